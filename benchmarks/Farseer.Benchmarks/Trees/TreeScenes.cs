using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.Joints;
using Farseer.Engine.Shapes;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;

namespace Farseer.Benchmarks.Trees;

/// <summary>Worlds of which all bodies that move belong to trees of joints, or lie on one.</summary>
internal static class TreeScenes
{
    private const ColliderFlags Solid = ColliderFlags.CollisionEnabled | ColliderFlags.ResponseEnabled;
    private const float Radius = 0.05f;
    private const float Inertia = 1f / 12;

    /// <summary>Ropes of links of 1 kg and 1 m that hang from nails, or are let go from the side.</summary>
    public static World Ropes(int ropes, int links, bool swing)
    {
        World world = Make();
        for (int rope = 0; rope < ropes; rope++)
        {
            double x = rope * 2.5 * links;
            Vector2 along = swing ? new Vector2(1, 0) : new Vector2(0, -1);
            AddRope(world, x, links, along);
        }

        return world;
    }

    /// <summary>Chains of 20 links of 1 kg and 1 m in the air or at a nail, each of joints of one kind.</summary>
    /// <param name="chains">How many.</param>
    /// <param name="kind">The kind of all joints.</param>
    /// <param name="nailed">The first link hangs on the world by a joint of the kind.</param>
    public static World Chains(int chains, JointKind kind, bool nailed)
    {
        const int Links = 20;
        World world = Make();
        for (int chain = 0; chain < chains; chain++)
        {
            Handle before = World.WorldFrame;
            Vector2 held = new Vector2(chain * 50f, 0);
            for (int i = 0; i < Links; i++)
            {
                Handle link = Add(world, ShapeBuilder.Box(1, 2 * Radius), new Vector2((chain * 50f) + i + 0.5f, 0), 0, 1, Inertia, 1, 2);
                world.Bodies.State[link.Index].LinearVelocity = new Vector2(0, 0.1f * (((7 * i) + chain) % 5));
                if (nailed || i > 0)
                {
                    Join(world, kind, before, link, held);
                }

                before = link;
                held = new Vector2(0.5f, 0);
            }
        }

        return world;
    }

    /// <summary>Chains of four links at the world, each link joined to the one before in the same way.</summary>
    /// <param name="chains">How many.</param>
    /// <param name="link">What joins them.</param>
    /// <param name="floor">They lie on a floor.</param>
    public static World Crowd(int chains, TreeKinds.Link link, bool floor)
    {
        const int Links = 4;
        World world = Make();
        if (floor)
        {
            AddFloor(world);
        }

        for (int chain = 0; chain < chains; chain++)
        {
            Handle before = World.WorldFrame;
            Vector2 held = new Vector2(chain * 10f, 0.1f);
            for (int i = 0; i < Links; i++)
            {
                Vector2 at = new Vector2((chain * 10f) + i + 0.5f, 0.1f);
                Handle part = Add(world, ShapeBuilder.Box(0.9f, 4 * Radius), at, 0, 1, Inertia, 1, 2);
                JoinBy(world, link.Kind, link, before, part, held);
                if (link.With is { } second)
                {
                    TreeKinds.Link plain = link with { Flags = JointFlags.Enabled };
                    JoinBy(
                        world,
                        second,
                        plain,
                        link.WithWorld ? World.WorldFrame : before,
                        part,
                        link.WithWorld ? at - new Vector2(0.5f, 0) : held);
                }

                before = part;
                held = new Vector2(0.5f, 0);
            }
        }

        return world;
    }

    private static void JoinBy(World world, JointKind kind, TreeKinds.Link link, Handle a, Handle b, Vector2 anchorA)
    {
        JointSettings settings = Rigid(anchorA, new Vector2(-0.5f, 0));
        bool turns = kind is JointKind.Revolute or JointKind.AngleLimit;
        settings.AxisY = 1;
        settings.Lower = turns ? -0.1 : kind == JointKind.Slider ? 0 : -0.05;
        settings.Upper = 0.1;
        settings.Softness = link.Softness;
        settings.Frequency = 4;
        settings.DampingRatio = 0.5;
        settings.MotorSpeed = 0.1;
        settings.MotorLimit = 20;
        settings.TorqueLimit = 20;
        settings.Ratio = kind == JointKind.Target ? 0 : 1;
        if (kind == JointKind.Distance || kind == JointKind.Pulley)
        {
            settings.AnchorBY = 0.3;
            settings.Target = kind == JointKind.Distance ? 0.3 : 8;
            settings.GroundAX = a.Index == World.WorldFrame.Index ? anchorA.X : world.Bodies.Pose[a.Index].X;
            settings.GroundBX = world.Bodies.Pose[b.Index].X;
            settings.GroundAY = 4;
            settings.GroundBY = 4;
        }

        world.CreateJoint(kind, a, b, settings, link.Flags);
    }

    /// <summary>Links that hang one below the other on rods of 1 m, let go from the side.</summary>
    public static World Pendulums(int pendulums)
    {
        const int Weights = 10;
        World world = Make();
        for (int pendulum = 0; pendulum < pendulums; pendulum++)
        {
            Handle before = World.WorldFrame;
            Vector2 held = new Vector2(pendulum * 30f, 0);
            for (int i = 0; i < Weights; i++)
            {
                Vector2 at = new Vector2((pendulum * 30f) + i + 1f, 0);
                Handle weight = Add(world, ShapeBuilder.Box(4 * Radius, 4 * Radius), at, 0, 1, Inertia, 1, 2);
                JointSettings settings = Rigid(held, default);
                settings.Target = 1;
                world.CreateJoint(JointKind.Distance, before, weight, settings, JointFlags.Enabled);
                before = weight;
                held = default;
            }
        }

        return world;
    }

    /// <summary>Cranes: a foot on the world and five arms, each turned by a motor that is strong enough for its load.</summary>
    public static World Cranes(int cranes)
    {
        const int Arms = 5;
        World world = Make();
        for (int crane = 0; crane < cranes; crane++)
        {
            Handle before = World.WorldFrame;
            Vector2 held = new Vector2(crane * 20f, 0);
            for (int i = 0; i < Arms; i++)
            {
                Handle arm = Add(world, ShapeBuilder.Box(1, 2 * Radius), new Vector2((crane * 20f) + i + 0.5f, 0), 0, 1, Inertia, 1, 2);
                JointSettings settings = Rigid(held, new Vector2(-0.5f, 0));
                settings.MotorSpeed = 0.1 * (1 + i) * ((crane & 1) == 0 ? 1 : -1);
                settings.MotorLimit = 1000;
                world.CreateJoint(JointKind.Revolute, before, arm, settings, JointFlags.Enabled | JointFlags.Motor);
                before = arm;
                held = new Vector2(0.5f, 0);
            }
        }

        return world;
    }

    /// <summary>Cars in the air or on a floor: a body with two sprung and driven wheels.</summary>
    public static World Cars(int cars, bool floor)
    {
        World world = Make();
        if (floor)
        {
            AddFloor(world);
        }

        for (int car = 0; car < cars; car++)
        {
            Handle body = Add(world, ShapeBuilder.Box(2, 0.5f), new Vector2(car * 5f, floor ? 1 : 0), 0.1f * (car % 5), 10, 4, 1, 2);
            for (int side = -1; side <= 1; side += 2)
            {
                Handle wheel = Add(
                    world, ShapeBuilder.Circle(0.3f), new Vector2((car * 5f) + (side * 0.8f), (floor ? 1 : 0) - 0.4f), 0, 1, 0.045f, 1, 2);
                JointSettings settings = Rigid(new Vector2(side * 0.8f, -0.4f), default);
                settings.AxisY = 1;
                settings.Frequency = 4;
                settings.DampingRatio = 0.7;
                settings.MotorSpeed = -20;
                settings.MotorLimit = 0.5;
                world.CreateJoint(JointKind.Wheel, body, wheel, settings, JointFlags.Enabled | JointFlags.Motor | JointFlags.Spring);
            }
        }

        return world;
    }

    /// <summary>Bridges of 20 planks in an arc, each with a crate of ten planks' mass on it.</summary>
    public static World Bridges(int bridges)
    {
        const int Planks = 20;
        World world = Make();
        for (int bridge = 0; bridge < bridges; bridge++)
        {
            double x = bridge * 60.0;
            Handle before = World.WorldFrame;
            Vector2 end = new Vector2((float)x, 0);
            Vector2 held = end;
            for (int i = 0; i < Planks; i++)
            {
                float turn = (i - 9.5f) * 0.06f;
                Vector2 half = 0.5f * new Vector2(1f - (0.5f * turn * turn), turn);
                Handle plank = Add(world, ShapeBuilder.Box(1, 0.2f), end + half, (float)Math.Atan2(half.Y, half.X), 1, Inertia, 1, 2);
                Hinge(world, before, plank, held, new Vector2(-half.Length(), 0), null);
                before = plank;
                held = new Vector2(half.Length(), 0);
                end += 2 * half;
            }

            Hinge(world, before, World.WorldFrame, held, end, null);
            Vector2 above = new Vector2((float)(0.5 * (x + end.X)), -2);
            Add(world, ShapeBuilder.Box(2, 2), above, 0, 10, 10 * 4f / 6, 2, 1);
        }

        return world;
    }

    /// <summary>
    /// Puppets of eleven bodies and ten hinges with limits, falling on a floor; with friction in their hinges or without.
    /// </summary>
    public static World Ragdolls(int dolls, bool friction, bool floor)
    {
        World world = Make();
        if (floor)
        {
            AddFloor(world);
        }

        for (int i = 0; i < dolls; i++)
        {
            AddRagdoll(world, new Vector2((i - (dolls / 2)) * 4f, 1.2f + (0.1f * (i % 5))), 0.3f * (i % 7), friction);
        }

        return world;
    }

    private static void AddFloor(World world)
    {
        Handle ground =
            world.CreateBody(new BodyDef { X = 0, Y = -1, Mass = 1, Inertia = 1, Flags = BodyFlags.Enabled | BodyFlags.Static });
        Collide(world, ground, ShapeBuilder.Box(4000, 2), 2, 1);
    }

    private static void AddRagdoll(World world, Vector2 at, float spin, bool friction)
    {
        Handle Part(float x, float y, float width, float height)
        {
            float mass = 100 * width * height;
            float inertia = mass * ((width * width) + (height * height)) / 12;
            return Add(world, ShapeBuilder.Box(width, height), at + new Vector2(x, y), 0, mass, inertia, 1, 2);
        }

        void Bend(Handle a, Handle b, Vector2 anchorA, Vector2 anchorB, double lower, double upper) =>
            Hinge(world, a, b, anchorA, anchorB, (lower, upper, friction));

        Handle pelvis = Part(0, 0.05f, 0.3f, 0.2f);
        Handle chest = Part(0, 0.42f, 0.34f, 0.5f);
        Handle head = Part(0, 0.83f, 0.22f, 0.26f);
        Bend(pelvis, chest, new Vector2(0, 0.11f), new Vector2(0, -0.26f), -0.6, 0.6);
        Bend(chest, head, new Vector2(0, 0.27f), new Vector2(0, -0.14f), -0.7, 0.7);
        for (int side = -1; side <= 1; side += 2)
        {
            Handle upperArm = Part(side * 0.35f, 0.6f, 0.34f, 0.11f);
            Handle foreArm = Part(side * 0.67f, 0.6f, 0.34f, 0.09f);
            Bend(chest, upperArm, new Vector2(side * 0.19f, 0.18f), new Vector2(side * -0.16f, 0), -1.5, 1.5);
            Bend(upperArm, foreArm, new Vector2(side * 0.16f, 0), new Vector2(side * -0.16f, 0), side > 0 ? 0 : -2.4, side > 0 ? 2.4 : 0);
            Handle thigh = Part(side * 0.09f, -0.27f, 0.14f, 0.46f);
            Handle shin = Part(side * 0.09f, -0.7f, 0.11f, 0.44f);
            Bend(pelvis, thigh, new Vector2(side * 0.09f, -0.1f), new Vector2(0, 0.22f), -0.9, 0.9);
            Bend(thigh, shin, new Vector2(0, -0.22f), new Vector2(0, 0.21f), side > 0 ? -2.2 : 0, side > 0 ? 0 : 2.2);
        }

        world.Bodies.State[pelvis.Index].AngularVelocity = spin;
    }

    private static void AddRope(World world, double x, int links, Vector2 along)
    {
        Handle before = World.WorldFrame;
        Vector2 held = new Vector2((float)x, 0);
        for (int i = 0; i < links; i++)
        {
            Vector2 at = new Vector2((float)x, 0) + ((i + 0.5f) * along);
            Handle link = Add(world, ShapeBuilder.Box(1, 2 * Radius), at, along.X > 0 ? 0 : -0.5f * (float)Math.PI, 1, Inertia, 1, 2);
            Hinge(world, before, link, held, new Vector2(-0.5f, 0), null);
            before = link;
            held = new Vector2(0.5f, 0);
        }
    }

    private static World Make()
    {
        var world = new World();
        world.Settings.Gravity = new Vector2(0, -10);
        return world;
    }

    private static void Hinge(
        World world, Handle a, Handle b, Vector2 anchorA, Vector2 anchorB, (double Lower, double Upper, bool Friction)? limits)
    {
        JointSettings settings = Rigid(anchorA, anchorB);
        JointFlags flags = JointFlags.Enabled;
        if (limits is { } bounds)
        {
            settings.Lower = bounds.Lower;
            settings.Upper = bounds.Upper;
            settings.MotorLimit = 0.02;
            flags |= bounds.Friction ? JointFlags.Limit | JointFlags.Motor : JointFlags.Limit;
        }

        world.CreateJoint(JointKind.Revolute, a, b, settings, flags);
    }

    /// <summary>The next link of a chain; slides go across it by a metre to both sides.</summary>
    private static void Join(World world, JointKind kind, Handle a, Handle b, Vector2 anchorA)
    {
        JointSettings settings = Rigid(anchorA, new Vector2(-0.5f, 0));
        settings.AxisY = 1;
        settings.Lower = -1;
        settings.Upper = 1;
        world.CreateJoint(kind, a, b, settings, JointFlags.Enabled | JointFlags.Limit);
    }

    private static JointSettings Rigid(Vector2 anchorA, Vector2 anchorB)
    {
        JointSettings settings = default;
        settings.AnchorAX = anchorA.X;
        settings.AnchorAY = anchorA.Y;
        settings.AnchorBX = anchorB.X;
        settings.AnchorBY = anchorB.Y;
        settings.BiasFactor = 0.2;
        settings.MaxImpulse = double.PositiveInfinity;
        settings.Breakpoint = double.PositiveInfinity;
        settings.BreakForce = double.PositiveInfinity;
        return settings;
    }

    private static Handle Add(
        World world, ShapeGeometry shape, Vector2 at, float angle, float mass, float inertia, uint category, uint with)
    {
        Handle body =
            world.CreateBody(new BodyDef { X = at.X, Y = at.Y, Angle = angle, Mass = mass, Inertia = inertia, Flags = BodyFlags.Enabled });
        Collide(world, body, shape, category, with);
        return body;
    }

    private static void Collide(World world, Handle body, ShapeGeometry shape, uint category, uint with) =>
        world.CreateCollider(body, shape, new ColliderDef { Flags = Solid, Friction = 0.6f, Categories = category, CollidesWith = with });
}
