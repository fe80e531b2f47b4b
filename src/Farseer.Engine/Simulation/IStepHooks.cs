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

    /// <summary>A pair in contact, each step, if a collider of it asked for it.</summary>
    /// <param name="colliderA">The one created first.</param>
    /// <param name="colliderB">The other.</param>
    /// <param name="points">Where they touch.</param>
    /// <param name="began">They did not touch in the step before.</param>
    ContactAnswer OnContact(int colliderA, int colliderB, ReadOnlySpan<ContactPoint> points, bool began);

    /// <summary>A pair that touched no longer does.</summary>
    void OnSeparation(int colliderA, int colliderB);

    /// <summary>A pair pushed each other in this step, if that is asked for; after all that moves has moved.</summary>
    void OnPush(int colliderA, int colliderB, in PushRecord push);

    /// <summary>Forces act now: controllers, springs, user code.</summary>
    void ApplyForces(float dt);
}

/// <summary>What comes of telling that a pair touches.</summary>
internal enum ContactAnswer
{
    /// <summary>The pair responds.</summary>
    Respond,

    /// <summary>No response in this step.</summary>
    Refuse,

    /// <summary>One of the two is leaving, and nobody was told: no response, and no parting of what did not touch before.</summary>
    Untold,
}

/// <summary>How two colliders pushed each other in a step.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct PushRecord
{
    public double X;
    public double Y;

    /// <summary>What collider B's body was given.</summary>
    public double PushX;
    public double PushY;

    /// <summary>Unit normal from collider A to collider B.</summary>
    public Vector2 Normal;

    /// <summary>How fast the surfaces came together while they did not push; 0 or less: they did not.</summary>
    public float Approach;

    /// <summary>That was faster than what is rest.</summary>
    public bool IsHit;

    /// <summary>Impulses of the whole step, of all points together.</summary>
    public float NormalImpulse;
    public float TangentImpulse;
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

    /// <summary>
    /// What the contact gave in the step: the sum, if there is one, else the impulses of the last substep times the number of substeps.
    /// </summary>
    public float NormalImpulse;
    public float TangentImpulse;

    /// <summary>Names the pair of features that touch; stable from step to step.</summary>
    public uint FeatureId;
}
