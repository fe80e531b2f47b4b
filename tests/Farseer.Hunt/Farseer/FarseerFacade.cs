using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Hunt.Calls;
using Farseer.Hunt.Running;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace Farseer.Hunt.Farseer;

/// <summary>The model of Farseer Physics 2.0.</summary>
internal sealed class FarseerFacade : Facade
{
    private const string Body2Vector = "(Body,Body,Vector2)";

    public FarseerFacade()
        : base(
            new Catalogue(new FarseerNames()),
            new StepMember(typeof(PhysicsSimulator), (world, dt, _) => ((PhysicsSimulator)world).Update(dt), (world, dt, _)
                => $"{world}.Update({dt})"),
            new Member[]
            {
                ReferenceMember<Body, Vector2>.Of(nameof(Body.LinearVelocity), new PointKind(new Span(-10, 10, 1e-6f, 1e6f))),
                ReferenceMember<Body, float>.Of(nameof(Body.AngularVelocity), new NumberKind(new Span(-10, 10, 1e-6f, 1e6f))),
                new MethodMember(typeof(List<Arbiter>).GetMethod("Clear")!, new[] { new ItemKind(typeof(ArbiterList)) }, null, null),
            })
    {
    }

    public override string Name => "farseer";

    public override Type World => typeof(PhysicsSimulator);

    public override IReadOnlyList<string> Namespaces { get; } = new[]
    {
        "System", "System.Collections.Generic", "System.Numerics", "System.Threading", "FarseerGames.FarseerPhysics",
            "FarseerGames.FarseerPhysics.Collisions",
        "FarseerGames.FarseerPhysics.Controllers", "FarseerGames.FarseerPhysics.Dynamics", "FarseerGames.FarseerPhysics.Dynamics.Joints",
        "FarseerGames.FarseerPhysics.Dynamics.Springs", "FarseerGames.FarseerPhysics.Factories", "FarseerGames.FarseerPhysics.Interfaces",
    };

    public override Observer Observe() => new FarseerObserver();

    public override void Open(Decoder decoder)
    {
        Choices choices = decoder.Choices;
        bool isFree = decoder.Profile == Profile.Free;
        int simulator = AddSimulator(decoder, isFree ? Vector2.Zero : new Vector2(0, -10));
        if (!isFree)
        {
            int floor = decoder.Emit("BodyFactory.CreateRectangleBody(PhysicsSimulator,Single,Single,Single)", simulator, 200f, 2f, 1f);
            decoder.Emit("Body.set_Position(Vector2)", floor, new Vector2(0, -1));
            decoder.Emit("Body.set_IsStatic(Boolean)", floor, true);
            decoder.Emit("GeomFactory.CreateRectangleGeom(PhysicsSimulator,Body,Single,Single)", simulator, floor, 200f, 2f);
        }

        int count = 1 + choices.Below(choices.OneIn(8) ? 60 : 10);
        int columns = 1 + choices.Below(8);
        var bodies = new List<int>();
        for (int i = 0; i < count && !choices.AreSpent; i++)
        {
            Vector2 place = PlaceOf(i, columns);
            bodies.Add(AddBody(decoder, simulator, place));
            if (i > 0 && choices.OneIn(4))
            {
                int before = choices.Below(i);
                AddHardJoint(decoder, simulator, bodies[before], bodies[i], (place + PlaceOf(before, columns)) / 2);
            }
        }

        if (decoder.Profile >= Profile.Ordinary && choices.OneIn(4))
        {
            AddSimulator(decoder, new Vector2(0, -10));
        }
    }

    public override void Compose(Decoder decoder)
    {
        Choices choices = decoder.Choices;
        if (decoder.Pick(typeof(PhysicsSimulator)) is not { } simulator)
        {
            return;
        }

        switch (choices.Below(8))
        {
            case 0 or 1 or 2:
                AddBody(decoder, simulator, null);
                break;
            case 3 when decoder.Pick(typeof(Joint)) is { } joint:
                decoder.Emit("PhysicsSimulator.Add(Joint)", simulator, joint);
                break;
            case 4 when decoder.Pick(typeof(Spring)) is { } spring:
                decoder.Emit("PhysicsSimulator.Add(Spring)", simulator, spring);
                break;
            case 5 when decoder.Pick(typeof(Controller)) is { } controller:
                decoder.Emit("PhysicsSimulator.Add(Controller)", simulator, controller);
                break;
            case 6 when decoder.Pick(typeof(Body)) is { } one && decoder.Pick(typeof(Body)) is { } other:
                AddHardJoint(decoder, simulator, one, other, null);
                break;
            default:
                decoder.Emit(Step.Key, simulator);
                break;
        }
    }

    private static int AddSimulator(Decoder decoder, Vector2 gravity)
    {
        Choices choices = decoder.Choices;
        int simulator = decoder.Emit("newPhysicsSimulator(Vector2)", gravity);
        string? collider = choices.Below(5) switch { 0 => "SweepAndPruneCollider", 1 => "BruteForceCollider", 2 => "GridCollider", 3
            => "SelectiveSweepCollider", _ => null };
        if (collider is not null)
        {
            decoder.Emit("PhysicsSimulator.set_BroadPhaseCollider(IBroadPhaseCollider)", simulator,
                decoder.Emit($"new{collider}(PhysicsSimulator)", simulator));
        }

        decoder.Emit("PhysicsSimulator.set_AllowedPenetration(Single)", simulator, choices.Between(0.001f, 0.05f));
        decoder.Emit("PhysicsSimulator.set_AllowSleep(Boolean)", simulator);
        decoder.Emit("PhysicsSimulator.set_EnableReport(Boolean)", simulator);
        if (choices.Flag())
        {
            decoder.Emit("PhysicsSimulator.set_Iterations(Int32)", simulator, choices.OneIn(4) ? 1 + choices.Below(50)
                : 1 + choices.Below(10));
        }

        if (choices.OneIn(4))
        {
            decoder.Emit("PhysicsSimulator.set_WorkerCount(Int32)", simulator);
        }

        return simulator;
    }

    /// <param name="decoder">What it is read by.</param>
    /// <param name="simulator">Where it goes.</param>
    /// <param name="place">Anywhere if null.</param>
    private static int AddBody(Decoder decoder, int simulator, Vector2? place)
    {
        Choices choices = decoder.Choices;
        bool isUntouched = decoder.Profile < Profile.Ordinary;
        int body = decoder.Emit("BodyFactory.CreateRectangleBody(PhysicsSimulator,Single,Single,Single)", simulator, choices.Between(0.3f,
            1.4f), choices.Between(0.3f, 1.4f));
        decoder.Emit("Body.set_Position(Vector2)", body, place);
        decoder.Emit("Body.set_Rotation(Single)", body);
        decoder.Emit("Body.set_LinearDragCoefficient(Single)", body, isUntouched ? 0f : null);
        decoder.Emit("Body.set_RotationalDragCoefficient(Single)", body, isUntouched ? 0f : null);
        decoder.Emit("Body.ref_LinearVelocity(Vector2)", body);
        if (choices.Flag())
        {
            decoder.Emit("Body.ref_AngularVelocity(Single)", body);
        }

        if (!isUntouched && choices.OneIn(8))
        {
            decoder.Emit(choices.Flag() ? "Body.set_IsStatic(Boolean)" : "Body.set_IsKinematic(Boolean)", body, true);
        }
        else if (choices.OneIn(8))
        {
            decoder.Emit("Body.set_IsBullet(Boolean)", body, true);
        }

        for (int i = choices.OneIn(6) ? 2 : 1; i > 0; i--)
        {
            int geom = AddGeom(decoder, simulator, body);
            decoder.Emit("Geom.set_FrictionCoefficient(Single)", geom);
            decoder.Emit("Geom.set_RestitutionCoefficient(Single)", geom, isUntouched ? choices.Between(0, 0.8f) : null);
        }

        return body;
    }

    private static int AddGeom(Decoder decoder, int simulator, int body) => decoder.Choices.Below(10) switch
    {
        0 or 1 => decoder.Emit("GeomFactory.CreateRectangleGeom(PhysicsSimulator,Body,Single,Single)", simulator, body),
        2 => decoder.Emit("GeomFactory.CreateCircleGeom(PhysicsSimulator,Body,Single,Int32)", simulator, body,
            decoder.Choices.Between(0.1f, 0.7f)),
        3 => decoder.Emit("GeomFactory.CreateCapsuleGeom(PhysicsSimulator,Body,Vector2,Vector2,Single)", simulator, body, Near(decoder),
            Near(decoder), 0.3f),
        4 => decoder.Emit("GeomFactory.CreateSegmentGeom(PhysicsSimulator,Body,Vector2,Vector2)", simulator, body, Near(decoder),
            Near(decoder)),
        5 => decoder.Emit("GeomFactory.CreateEllipseGeom(PhysicsSimulator,Body,Single,Single,Int32)", simulator, body, 0.5f,
            decoder.Choices.Between(0.1f, 0.5f)),
        6 => decoder.Emit("GeomFactory.CreateRoundedRectangleGeom(PhysicsSimulator,Body,Single,Single,Single)", simulator, body, null,
            null, 0.1f),
        7 or 8 => decoder.Emit("GeomFactory.CreateChainGeom(PhysicsSimulator,Body,Vertices,Boolean)", simulator, body),
        _ => decoder.Emit("GeomFactory.CreatePolygonGeom(PhysicsSimulator,Body,Vertices,Single)", simulator, body, null, 0f),
    };

    private static Vector2 Near(Decoder decoder) => new(decoder.Choices.Between(-0.7f, 0.7f), decoder.Choices.Between(-0.7f, 0.7f));

    /// <summary>A joint that holds as the bodies stand, without springs and motors; of those whose places nobody knows, any.</summary>
    private static void AddHardJoint(Decoder decoder, int simulator, int one, int other, Vector2? middle)
    {
        int joint = decoder.Choices.Below(8) switch
        {
            0 or 1 => decoder.Emit("newRevoluteJoint" + Body2Vector, one, other, middle),
            2 => decoder.Emit("newWeldJoint" + Body2Vector, one, other, middle),
            3 => decoder.Emit("newPinJoint(Body,Vector2,Body,Vector2)", one, Near(decoder), other, Near(decoder)),
            4 => decoder.Emit("newDistanceJoint(Body,Vector2,Body,Vector2)", one, Near(decoder), other, Near(decoder)),
            5 => decoder.Emit("newRopeJoint(Body,Vector2,Body,Vector2,Single)", one, Near(decoder), other, Near(decoder),
                middle is null ? null : 30f),
            6 => decoder.Emit("newPrismaticJoint(Body,Body,Vector2,Vector2)", one, other, middle, Vector2.UnitX),
            _ => decoder.Emit("newAngleLimitJoint(Body,Body,Single,Single)", one, other, -7f, 7f),
        };
        if (joint >= 0)
        {
            decoder.Emit("PhysicsSimulator.Add(Joint)", simulator, joint);
        }
    }
}
