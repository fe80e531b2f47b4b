using System;
using System.Numerics;
using Farseer.Engine.Bodies;
using Farseer.Engine.BroadPhase;
using Farseer.Engine.Settings;
using Farseer.Engine.Shapes;
using Farseer.Engine.Stepping;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Simulation;

/// <summary>Owns the stores of one simulation. The facades create it, fill it and step it.</summary>
internal sealed partial class World
{
    public WorldSettings Settings { get; } = new WorldSettings();

    public StepProfile Profile { get; } = new StepProfile();

    public ShapeStore Shapes { get; } = new ShapeStore();

    public BodyStore Bodies { get; } = new BodyStore();

    public IStepHooks? Hooks { get; set; }

    /// <summary>Swappable at any time: pairs already found are kept.</summary>
    public IBroadPhase BroadPhase { get; set; } = null!;

    /// <summary>True while a step runs: structural changes then wait until its end.</summary>
    public bool IsStepping { get; private set; }

    public int ContactCount => throw new NotImplementedException();

    public Handle CreateBody(in BodyDef def) => throw new NotImplementedException();

    /// <summary>Removes the body with its colliders and contacts; inside a step, at its end.</summary>
    public void DestroyBody(Handle body) => throw new NotImplementedException();

    public Handle CreateCollider(Handle body, ShapeGeometry shape, in ColliderDef def) => throw new NotImplementedException();

    public void DestroyCollider(Handle collider) => throw new NotImplementedException();

    /// <summary>Teleports a body; legal at any time, also from hooks.</summary>
    public void SetPosition(Handle body, double x, double y) => throw new NotImplementedException();

    public void SetAngle(Handle body, double angle) => throw new NotImplementedException();

    /// <summary>Mass and inertia; both above 0 and finite.</summary>
    public void SetMass(Handle body, float mass, float inertia) => throw new NotImplementedException();

    /// <summary>Sets and clears flags (static, enabled, ignore gravity, ...) with everything that follows from them.</summary>
    public void SetFlags(Handle body, BodyFlags set, BodyFlags clear) => throw new NotImplementedException();

    /// <summary>After a change of a collider's filter: its pairs are judged anew in the next step.</summary>
    public void Refilter(Handle collider) => throw new NotImplementedException();

    public ref ColliderInfo Collider(Handle collider) => throw new NotImplementedException();

    /// <summary>Advances by <paramref name="dt"/> seconds.</summary>
    public void Step(float dt) => throw new NotImplementedException();

    /// <summary>World box of a collider at its present pose.</summary>
    public void GetColliderBox(Handle collider, out Vector2 min, out Vector2 max) => throw new NotImplementedException();

    /// <summary>Calls <paramref name="visitor"/> for every pair in contact, in the order of the colliders.</summary>
    public void VisitContacts(IContactVisitor visitor) => throw new NotImplementedException();

    /// <summary>64-bit hash of the state of all bodies (poses, velocities), equal on every platform.</summary>
    public ulong StateHash() => throw new NotImplementedException();

    /// <summary>Deepest overlap of two solid colliders at the end of the last step, 0 if none.</summary>
    public float LargestPenetration() => throw new NotImplementedException();
}

internal interface IContactVisitor
{
    void Visit(int colliderA, int colliderB, ReadOnlySpan<ContactPoint> points);
}
