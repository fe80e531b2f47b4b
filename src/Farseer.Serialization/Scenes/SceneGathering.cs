using System.Collections.Generic;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics.Serialization.Scenes;

/// <summary>What belongs to a scene: what is in the simulator or on its way there, and whatever that refers to.</summary>
internal sealed class SceneGathering
{
    private readonly SceneContents _contents;

    private SceneGathering(SceneContents contents) => _contents = contents;

    /// <param name="simulator">The simulator.</param>
    /// <param name="paths">Paths that are saved with it.</param>
    /// <param name="remembered">Whatever else its state refers to.</param>
    public static SceneContents Of(PhysicsSimulator simulator, IEnumerable<Path> paths, IEnumerable<object> remembered)
    {
        var gathering = new SceneGathering(new SceneContents(simulator));
        SceneMembers members = SceneMembers.Of(simulator);
        members.Bodies.ForEach(gathering.Enter);
        members.Geoms.ForEach(gathering.Enter);
        members.Joints.ForEach(gathering.Enter);
        members.Springs.ForEach(gathering.Enter);
        gathering.Enter(simulator.InactivityController);
        members.Controllers.ForEach(gathering.Enter);
        foreach (object item in remembered)
        {
            gathering.EnterAny(item);
        }

        foreach (Path path in paths)
        {
            if (gathering._contents.Enter(gathering._contents.PathItems, path))
            {
                path.Bodies.ForEach(gathering.Enter);
                path.Geoms.ForEach(gathering.Enter);
                path.Joints.ForEach(gathering.Enter);
                path.Springs.ForEach(gathering.Enter);
            }
        }

        gathering.EnterParts();
        gathering._contents.SortGeoms();
        return gathering._contents;
    }

    private void EnterAny(object item)
    {
        switch (item)
        {
            case Body body:
                Enter(body);
                break;
            case Geom geom:
                Enter(geom);
                break;
            case Joint joint:
                Enter(joint);
                break;
            case Spring spring:
                Enter(spring);
                break;
            case Controller controller:
                Enter(controller);
                break;
        }
    }

    private void Enter(Body? body)
    {
        if (body is not null)
        {
            _contents.Enter(_contents.BodyItems, body);
        }
    }

    private void Enter(Geom geom)
    {
        if (geom.Form is not null && geom.Body is not null)
        {
            _contents.Enter(_contents.GeomItems, geom);
        }
    }

    private void Enter(Joint joint)
    {
        if (_contents.Enter(_contents.JointItems, joint))
        {
            Enter(joint.FirstBody);
            Enter(joint.SecondBody);
        }
    }

    private void Enter(Spring spring)
    {
        if (_contents.Enter(_contents.SpringItems, spring))
        {
            Enter(spring.FirstBody);
            Enter(spring.SecondBody);
        }
    }

    private void Enter(Controller controller)
    {
        // A fluid is made of its wave, which stands before it.
        if (controller is FluidDragController { Container: Controller container })
        {
            Enter(container);
        }

        if (_contents.Enter(_contents.ControllerItems, controller) && controller is FluidDragController fluid)
        {
            fluid.Geoms.ForEach(Enter);
        }
    }

    /// <summary>The bodies of geoms and the geoms of bodies, until there are no more.</summary>
    private void EnterParts()
    {
        int nextBody = 0;
        int nextGeom = 0;
        while (nextBody < _contents.Bodies.Count || nextGeom < _contents.Geoms.Count)
        {
            for (; nextBody < _contents.Bodies.Count; nextBody++)
            {
                foreach (Geom geom in _contents.Bodies[nextBody].Geoms)
                {
                    Enter(geom);
                }
            }

            for (; nextGeom < _contents.Geoms.Count; nextGeom++)
            {
                Enter(_contents.Geoms[nextGeom].Body);
            }
        }
    }
}

/// <summary>What is in a simulator or on its way there, in the order of its lists.</summary>
internal sealed class SceneMembers
{
    public List<Body> Bodies { get; } = new List<Body>();

    public List<Geom> Geoms { get; } = new List<Geom>();

    public List<Joint> Joints { get; } = new List<Joint>();

    public List<Spring> Springs { get; } = new List<Spring>();

    public List<Controller> Controllers { get; } = new List<Controller>();

    public static SceneMembers Of(PhysicsSimulator simulator)
    {
        var members = new SceneMembers();
        simulator.ListPresent(members.Bodies);
        members.Geoms.AddRange(simulator.ListPresent());
        simulator.ListPresent(members.Joints);
        simulator.ListPresent(members.Springs);
        simulator.ListPresent(members.Controllers);
        return members;
    }
}
