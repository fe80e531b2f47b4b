using System;

namespace Box2D.Common;

/// <summary>
/// The constants of version 2.0.2. They are what the original's solver was tuned by; here those with a meaning for this engine
/// act (named below), the others are kept so that code which reads them compiles.
/// </summary>
/// <example>
/// <code>
/// int corners = b2Settings.b2_maxPolygonVertices;
/// </code>
/// </example>
public static class b2Settings
{
    /// <summary>Largest unsigned number of 16 bits: the original's mark for "none".</summary>
    public const int USHRT_MAX = 0x0000ffff;

    /// <summary>π.</summary>
    public const float b2_pi = (float)System.Math.PI;

    /// <summary>Points of a manifold at most: 2.</summary>
    public const int b2_maxManifoldPoints = 2;

    /// <summary>
    /// Places in a new <see cref="Box2D.Collision.Shapes.b2PolygonDef.vertices"/>: 8. It is no limit here: a longer array may be set.
    /// </summary>
    public const int b2_maxPolygonVertices = 8;

    /// <summary>Shapes at most in the original: 512. No limit here.</summary>
    public const int b2_maxProxies = 512;

    /// <summary>Pairs at most in the original: 4096. No limit here.</summary>
    public const int b2_maxPairs = 8 * b2_maxProxies;

    /// <summary>Depth of contacts that is no error, metres: 0.005. Contacts rest at half of it.</summary>
    public const float b2_linearSlop = 0.005f;

    /// <summary>Angle by which the original's joints may be off, radians: 2 degrees. Joints here give way to rounding only.</summary>
    public const float b2_angularSlop = (float)(2.0 / 180.0 * System.Math.PI);

    /// <summary>
    /// By how much the core shapes of <see cref="Box2D.Collision.Shapes.b2PolygonShape.GetCoreVertices"/> are shrunk, metres: 0.04.
    /// </summary>
    public const float b2_toiSlop = 8.0f * b2_linearSlop;

    /// <summary>Contacts in a continuous sub-step of the original: 32. No limit here.</summary>
    public const int b2_maxTOIContactsPerIsland = 32;

    /// <summary>Approach slower than this does not bounce, m/s: 1. Acts.</summary>
    public const float b2_velocityThreshold = 1.0f;

    /// <summary>Largest position correction of the original in an iteration, metres: 0.2. Not used here.</summary>
    public const float b2_maxLinearCorrection = 0.2f;

    /// <summary>Largest correction of an angle of the original in an iteration, radians: 8 degrees. Not used here.</summary>
    public const float b2_maxAngularCorrection = (float)(8.0 / 180.0 * System.Math.PI);

    /// <summary>
    /// Speed to which the original cuts bodies, m/s: 200. Restitutions above 1 drive bodies no further; everything is cut with
    /// <see cref="Box2D.Dynamics.Box2DFlash202Quirks.SpeedLimits"/>.
    /// </summary>
    public const float b2_maxLinearVelocity = 200.0f;

    /// <summary>The square of <see cref="b2_maxLinearVelocity"/>.</summary>
    public const float b2_maxLinearVelocitySquared = b2_maxLinearVelocity * b2_maxLinearVelocity;

    /// <summary>
    /// Spin to which the original cuts bodies, rad/s: 250. Restitutions above 1 drive bodies no further; everything is cut with
    /// <see cref="Box2D.Dynamics.Box2DFlash202Quirks.SpeedLimits"/>.
    /// </summary>
    public const float b2_maxAngularVelocity = 250.0f;

    /// <summary>The square of <see cref="b2_maxAngularVelocity"/>.</summary>
    public const float b2_maxAngularVelocitySquared = b2_maxAngularVelocity * b2_maxAngularVelocity;

    /// <summary>Share of an overlap that the original removes in an iteration: 0.2. Not used here.</summary>
    public const float b2_contactBaumgarte = 0.2f;

    /// <summary>Rest after which a body sleeps, seconds: 0.5. Acts.</summary>
    public const float b2_timeToSleep = 0.5f;

    /// <summary>Speed below which a body rests, m/s: 0.01. Acts.</summary>
    public const float b2_linearSleepTolerance = 0.01f;

    /// <summary>Spin below which a body rests, rad/s: 2/180. Acts.</summary>
    public const float b2_angularSleepTolerance = (float)(2.0 / 180.0);

    /// <summary>Throws if a condition does not hold.</summary>
    /// <param name="a">The condition.</param>
    /// <exception cref="InvalidOperationException"><paramref name="a"/> is false.</exception>
    public static void b2Assert(bool a)
    {
        if (!a)
        {
            throw new InvalidOperationException("The assertion does not hold.");
        }
    }
}
