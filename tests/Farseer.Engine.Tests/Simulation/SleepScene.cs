using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Springs;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Tests.Simulation;

/// <summary>A world in which bodies may sleep, on a ground whose top is y = 0; lengths times a scale.</summary>
internal sealed class SleepScene : IStepHooks
{
    public const float Dt = 1f / 60;

    private readonly float _scale;

    public SleepScene(float scale = 1, bool allowSleep = true, float gravity = 10)
    {
        _scale = scale;
        World.Settings.Gravity = new Vector2(0, -gravity * scale);
        World.Settings.AllowedPenetration = 0.005f * scale;
        World.Settings.AllowSleep = allowSleep;
        World.Hooks = this;
        Ground = Box(0, -0.5f, 100, 1, BodyFlags.Static);
    }

    public World World { get; } = new World();

    public Handle Ground { get; }

    public List<SpringDef> Springs { get; } = new List<SpringDef>();

    public List<string> Events { get; } = new List<string>();

    public ColliderFlags Listen { get; set; }

    public Action? Forces { get; set; }

    public Handle Box(float x, float y, float width, float height, BodyFlags flags = BodyFlags.None)
    {
        Handle body = Bare(x, y, width, height, flags);
        Cover(body, width, height);
        return body;
    }

    public Handle Bare(float x, float y, float width, float height, BodyFlags flags = BodyFlags.None)
    {
        float mass = width * height;
        return World.CreateBody(new BodyDef
        {
            X = x * _scale,
            Y = y * _scale,
            Mass = mass,
            Inertia = mass * ((width * width) + (height * height)) / 12 * _scale * _scale,
            Flags = BodyFlags.Enabled | flags,
        });
    }

    public Handle Cover(Handle body, float width, float height, ColliderFlags flags = ColliderFlags.ResponseEnabled) =>
        World.CreateCollider(body, ShapeBuilder.Box(width * _scale, height * _scale), new ColliderDef
        {
            Flags = ColliderFlags.CollisionEnabled | flags | Listen,
            Friction = 0.6f,
            Categories = 1,
            CollidesWith = 1,
        });

    public List<Handle> Pyramid(int rows)
    {
        var boxes = new List<Handle>();
        for (int row = 0; row < rows; row++)
        {
            for (int i = 0; i < rows - row; i++)
            {
                boxes.Add(Box((i - (0.5f * (rows - 1 - row))) * 1.1f, 0.5f + row, 1, 1));
            }
        }

        return boxes;
    }

    public Handle Hinge(Handle a, Handle b, float x, float y) =>
        World.CreateJoint(JointKind.Revolute, a, b, Anchors(a, b, x, y), JointFlags.Enabled);

    public JointSettings Anchors(Handle a, Handle b, float x, float y) => new JointSettings
    {
        AnchorAX = (x * _scale) - World.Bodies.Pose[a.Index].X,
        AnchorAY = (y * _scale) - World.Bodies.Pose[a.Index].Y,
        AnchorBX = (x * _scale) - World.Bodies.Pose[b.Index].X,
        AnchorBY = (y * _scale) - World.Bodies.Pose[b.Index].Y,
        BiasFactor = 0.2,
        MaxImpulse = double.PositiveInfinity,
        Breakpoint = double.PositiveInfinity,
        BreakForce = double.PositiveInfinity,
    };

    public void Step(int count = 1)
    {
        for (int i = 0; i < count; i++)
        {
            World.Step(Dt);
        }
    }

    /// <summary>Steps until all that can sleep does.</summary>
    public void Settle(int atMost = 1200)
    {
        int movable = 0;
        for (int body = 1; body < World.Bodies.Ids.End; body++)
        {
            const BodyFlags Awake = BodyFlags.Alive | BodyFlags.Enabled;
            BodyFlags flags = World.Bodies.Flags[body];
            movable += (flags & (Awake | BodyFlags.Static | BodyFlags.Kinematic)) == Awake ? 1 : 0;
        }

        for (int i = 0; i < atMost && World.Sleep.AsleepCount < movable; i++)
        {
            Step();
        }

        Xunit.Assert.Equal(movable, World.Sleep.AsleepCount);
    }

    public void SetVelocity(Handle body, float x, float y)
    {
        World.Sleep.NoteHandled(body.Index);
        World.Bodies.State[body.Index].LinearVelocity = new Vector2(x, y) * _scale;
    }

    public bool JudgesPairs => true;

    public bool AcceptPair(int colliderA, int colliderB) => true;

    public ContactAnswer OnContact(int colliderA, int colliderB, ReadOnlySpan<ContactPoint> points, bool began)
    {
        Events.Add($"touch {colliderA} {colliderB}");
        return ContactAnswer.Respond;
    }

    public void OnSeparation(int colliderA, int colliderB) => Events.Add($"part {colliderA} {colliderB}");

    public void OnPush(int colliderA, int colliderB, in PushRecord push)
    {
    }

    public void ApplyForces(float dt)
    {
        foreach (SpringDef spring in Springs)
        {
            World.ApplySpring(spring);
        }

        Forces?.Invoke();
    }
}
