using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>
/// What a first program gets, with gravity given and nothing else set: the README's stack, its hello world, and a box that slides.
/// </summary>
public sealed class UntouchedDefaults : Scene
{
    private const int Count = 20;
    private const float FloorTop = 0.5f;
    private const float Speed = 3;

    private readonly List<Body> _stack = [];
    private Body? _hello;
    private Body? _sliding;

    public override string Name => "defaults";

    public override string Title => "Nothing set";

    public override string Description =>
        "Nothing is set but gravity: 20 boxes stand, the box of hello world rests, and one slides as its drag says.";

    public override SceneView View => new(new Vector2(-12f, -1f), new Vector2(44f, 22f));

    public override void Build(PhysicsSimulator simulator)
    {
        simulator.Gravity = new Vector2(0, -10);
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 200, 1, 1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 200, 1);
        _stack.Clear();
        for (int i = 0; i < Count; i++)
        {
            _stack.Add(Box(simulator, new Vector2(-8, FloorTop + 0.5f + i)));
        }

        _hello = Box(simulator, new Vector2(0, 5));
        _sliding = Box(simulator, new Vector2(8, FloorTop + 0.5f));
        _sliding.LinearVelocity = new Vector2(Speed, 0);
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double height = FloorTop + Count - 0.5;
        double drag = _sliding!.LinearDragCoefficient / _sliding.Mass;
        double time = Steps * (double)Dt;
        double way = Speed * -(Math.Exp(-drag * time) - 1) / drag;
        return
        [
            // As the README says.
            SceneOutcome.Error("20 boxes: error of their height (m)", _stack[^1].PositionY, height, 0.0006),
            SceneOutcome.AtMost("20 boxes: drift to the side (m)", Math.Abs(_stack[^1].PositionX + 8), 1e-6),
            SceneOutcome.Error("hello world: error of the height (m)", _hello!.PositionY, FloorTop + 0.5, 0.0001),

            // Drag takes 1e-5 m/s in a substep, which a float of 3 m/s rounds by 1.2 % at most; of the way drag takes 0.5 %.
            SceneOutcome.Error("sliding box: error of the way, share", (_sliding.PositionX - 8) / way, 1, 6e-5),
        ];
    }

    private static Body Box(PhysicsSimulator simulator, Vector2 position)
    {
        Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
        body.Position = position;
        GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1);
        return body;
    }
}
