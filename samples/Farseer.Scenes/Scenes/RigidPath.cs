using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>An arch of links whose hinges are locked by their limits: a rigid path that stands on its feet and carries a box.</summary>
public sealed class RigidPath : Scene
{
    private const float Radius = 4f;
    private Path? _arch;
    private Body? _box;
    private double _span;
    private double _worst;
    private double _start;

    public override string Name => "rigid-path";

    public override string Title => "Rigid path";

    public override string Description =>
        "An arch of links with locked hinges lands on its feet and carries a box: its span stays what it was.";

    public override int Steps => 900;

    public override SceneView View => new(new Vector2(-8f, -1f), new Vector2(8f, 9f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 30f, 0f, 0.8f);
        _arch = new Path(0.8f, 0.4f, 1f, false);
        for (int i = 0; i <= 8; i++)
        {
            double angle = Math.PI * (1.0 - (i / 8.0));
            _arch.Add(new Vector2((float)(Radius * Math.Cos(angle)), 1f + (float)(Radius * Math.Sin(angle))));
        }

        _arch.Update();
        _arch.CreateGeoms(1);
        _arch.LinkBodies(LinkType.RevoluteJoint, 0f, 0f, 0f, 0f);
        Chains.Harden(_arch);
        Chains.SetFriction(_arch, 0.8f);
        foreach (Joint joint in _arch.Joints)
        {
            ((RevoluteJoint)joint).AreLimitsEnabled = true;
        }

        _arch.AddToPhysicsSimulator(simulator);
        _box = Make.Box(simulator, new Vector2(0f, 7f), 1.5f, 1f, 0.8f).Body;
        _box.Mass = 10f;
        _box.MomentOfInertia = 10f * ((1.5f * 1.5f) + 1f) / 12f;
        _span = Span();
        _start = _box.Position.Y;
        _worst = 0.0;
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        _worst = Math.Max(_worst, Chains.WidestGap(_arch!));
    }

    public override IReadOnlyList<SceneOutcome> Check() =>
    [
        SceneOutcome.AtMost("widest gap of a hinge (m)", _worst, 1e-6),
        SceneOutcome.Error("span of the arch (m)", Span(), _span, 1e-2),
        SceneOutcome.AtMost("speed of the box (m/s)", _box!.LinearVelocity.Length(), 0.02),
        SceneOutcome.AtLeast("height of the box (m)", _box.Position.Y, Radius),
    ];

    private double Span() => (_arch!.Bodies[^1].Position - _arch.Bodies[0].Position).Length();
}
