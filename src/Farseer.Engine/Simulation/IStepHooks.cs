using System;
using System.Numerics;
using System.Runtime.InteropServices;

namespace Farseer.Engine.Simulation;

/// <summary>
/// What a facade hears during a step. Every call comes on the thread that called <c>Step</c>, in an order that depends on the
/// state alone, never inside a parallel phase. Structural changes made from here go through the deferred changes of the world.
/// </summary>
internal interface IStepHooks
{
    /// <summary>False: <see cref="AcceptPair"/> would say yes to all, and is not asked; it may change within a step.</summary>
    bool JudgesPairs { get; }

    /// <summary>Asked once when two colliders first overlap with their boxes and pass the filters; false: no pair is made.</summary>
    bool AcceptPair(int colliderA, int colliderB);

    /// <summary>A pair in contact, each step, if a collider of it asked for it. False cancels the response in this step.</summary>
    bool OnContact(int colliderA, int colliderB, ReadOnlySpan<ContactPoint> points);

    /// <summary>A pair that touched no longer does.</summary>
    void OnSeparation(int colliderA, int colliderB);

    /// <summary>Forces act now: controllers, springs, user code.</summary>
    void ApplyForces(float dt);
}

/// <summary>One contact point as readers see it.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct ContactPoint
{
    /// <summary>World position, midway between the two surfaces.</summary>
    public double X;
    public double Y;

    /// <summary>Unit normal from collider A to collider B.</summary>
    public Vector2 Normal;

    /// <summary>Distance of the surfaces; negative when they overlap.</summary>
    public float Separation;

    /// <summary>Impulses of the last substep times the number of substeps: what the contact gave in the step.</summary>
    public float NormalImpulse;
    public float TangentImpulse;

    /// <summary>Names the pair of features that touch; stable from step to step.</summary>
    public uint FeatureId;
}
