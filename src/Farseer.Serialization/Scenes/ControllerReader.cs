using System.Linq;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Interfaces;
using FarseerGames.FarseerPhysics.Serialization.Documents;
using FarseerGames.FarseerPhysics.Serialization.Tables;

namespace FarseerGames.FarseerPhysics.Serialization.Scenes;

/// <summary>Makes controllers.</summary>
internal sealed class ControllerReader
{
    private readonly SceneContents _contents;
    private readonly SceneFileOptions _options;

    public ControllerReader(SceneContents contents, SceneFileOptions options)
    {
        _contents = contents;
        _options = options;
    }

    public Controller Read(SceneObject members)
    {
        SceneNode name = members.Take("kind");
        string text = name.Text();
        ControllerKindOfFile kind =
            ControllerTables.Kinds.FirstOrDefault(k => k.Name == text) ?? throw name.Error("is no kind of controller");
        bool isOfSimulator = members.TryTake("isOfSimulator", out SceneNode own) && own.Flag();
        Controller controller = isOfSimulator && kind.Type == typeof(InactivityController)
            ? _contents.Simulator.InactivityController : kind.Make(_contents.Simulator);
        if (isOfSimulator && _contents.PlaceOf(controller) >= 0)
        {
            throw own.Error("is said of two controllers");
        }

        kind.Table.Read(controller, members);
        SceneObject.Try(members.Node, controller, members, static (c, m) => c.VisitHidden(new HiddenReader(m)));
        switch (controller)
        {
            case WaveController wave:
                CheckWave(wave, members);
                break;
            case WindController wind:
                wind.Area = Box(members, "areaMin", "areaMax");
                break;
            case FluidDragController fluid:
                ReadFluid(fluid, members);
                break;
        }

        if (members.TryTake("tag", out SceneNode tag))
        {
            controller.Tag = _options.Tag(tag.Text());
        }

        return controller;
    }

    private static void CheckWave(WaveController wave, SceneObject members)
    {
        int nodes = wave.CurrentWave?.Length ?? 0;
        wave.CountNodes(out int previous, out int result, out int places);
        if (nodes == 1 || previous != nodes || result != nodes || places != nodes)
        {
            throw members.Node.Error(
                "must have as many numbers in currentWave, previousWave, resultWave and xPosition, none or at least 2");
        }
    }

    private void ReadFluid(FluidDragController fluid, SceneObject members)
    {
        System.Numerics.Vector2 gravity = fluid.Gravity;
        IFluidContainer? container = null;
        if (members.TryTake("wave", out SceneNode wave))
        {
            container = SceneReader.ItemAt(wave, _contents.ControllerItems, wave.Whole()) as WaveController
                ?? throw wave.Error("must be the place of a wave that stands before the fluid");
        }
        else if (Box(members, "containerMin", "containerMax") is { } box)
        {
            container = new AABBFluidContainer(box);
        }

        if (container is not null)
        {
            SceneObject.Try(
                members.Node,
                fluid,
                container,
                (f, c) => f.Initialize(c, f.Density, f.LinearDragCoefficient, f.RotationalDragCoefficient, gravity));
        }

        int[] geoms = members.TryTake("geoms", out SceneNode places) ? places.Wholes() : [];
        foreach (int place in geoms)
        {
            fluid.AddGeom(SceneReader.ItemAt(places, _contents.GeomItems, place));
        }

        int[] entered = members.TryTake("entered", out SceneNode flags) ? flags.Wholes() : [];
        if (entered.Length > fluid.Entered.Count)
        {
            throw flags.Error("must have an item for each geom");
        }

        for (int i = 0; i < entered.Length; i++)
        {
            fluid.Entered[i] = entered[i] != 0;
        }
    }

    private static AABB? Box(SceneObject members, string min, string max)
    {
        if (!members.TryTake(min, out SceneNode lower))
        {
            return null;
        }

        AABB? box = null;
        SceneObject.Try(lower, lower.Vector(), members.Take(max).Vector(), (a, b) => box = new AABB(a, b));
        return box;
    }
}
