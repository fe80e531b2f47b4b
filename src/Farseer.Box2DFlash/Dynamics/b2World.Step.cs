using System;
using Box2D.Bridge;
using Box2D.Common;
using Box2D.Dynamics.Joints;

namespace Box2D.Dynamics;

/// <content>The step.</content>
public partial class b2World
{
    /// <summary>
    /// Moves the world on. Listeners are told within the step; see <see cref="b2ContactListener"/>. What one of them throws comes out
    /// of here when the step is complete.
    /// </summary>
    /// <param name="dt">Time, seconds; finite and 0 or more. 0 does nothing. 1/60 is usual.</param>
    /// <param name="iterations">
    /// Accuracy, above 0: the step is solved in so many substeps, and the error falls fourfold with each doubling. 10 is usual.
    /// </param>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of its range.</exception>
    /// <exception cref="InvalidOperationException">The call comes from a listener.</exception>
    public void Step(float dt, int iterations)
    {
        Require.NotNegative(dt, nameof(dt));
        Require.Positive(iterations, nameof(iterations));
        if (_locked)
        {
            throw new InvalidOperationException("The world is locked: Step must not be called by a listener of a step.");
        }

        _locked = true;
        try
        {
            if (dt > 0)
            {
                if ((Quirks & Box2DFlash202Quirks.SpeedLimits) != 0)
                {
                    CutSpeeds(dt);
                }

                if ((Quirks & Box2DFlash202Quirks.MouseJointSlowsTurn) != 0)
                {
                    SlowDragged();
                }

                Engine.Step(dt, iterations);
                FreezeOutside();
            }

            DrawKept();
        }
        finally
        {
            _locked = false;
        }

        Engine.Rethrow();
    }

    /// <summary>
    /// A hash of the positions and velocities of all bodies, equal on every platform for equal worlds: to compare runs, for example of two
    /// players. What else later steps depend on is in <see cref="StateHash"/>. (An addition to the original.)
    /// </summary>
    /// <returns>The hash.</returns>
    public ulong MotionHash() => Engine.MotionHash();

    /// <summary>
    /// Whether contacts and joints start a step from the impulses of the one before. Default true. Without, stacks sink into each other and
    /// loads hang lower: it is there to compare with.
    /// </summary>
    /// <param name="flag">False forgets the impulses at the start of each step.</param>
    public void SetWarmStarting(bool flag) => Engine.SetWarmStarting(flag);

    /// <summary>
    /// Sets whether overlaps are pushed out and joints that drifted apart are pulled together. Default true. Without, surfaces and joints
    /// still stop what would make it worse, so nothing falls through, but an overlap stays and a joint comes apart little by little.
    /// Springs (distance joints with a frequency, mouse joints) pull in any case.
    /// </summary>
    /// <param name="flag">False leaves overlaps and joint errors as they are.</param>
    public void SetPositionCorrection(bool flag) => Engine.SetPositionCorrection(flag);

    /// <summary>Sets whether fast bodies are kept from passing through others. Default true.</summary>
    /// <param name="flag">False switches it off.</param>
    public void SetContinuousPhysics(bool flag) => Engine.SetContinuous(flag);

    /// <summary>
    /// How many threads share the work of a step, the calling one included. The motion is the same, bit for bit, whatever the number, and
    /// listeners are told on the calling thread alone. Only large steps wake the other threads, which sleep between steps and end
    /// when the world is dropped. Default 1: no threads. (An addition to the original.)
    /// </summary>
    /// <param name="count">At least 0, which stands for as many as there are processors; more are not used.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="count"/> is negative.</exception>
    public void SetWorkerCount(int count) =>
        Engine.World.SetWorkers(Require.NotNegative(count, nameof(count)), Environment.ProcessorCount, null);

    /// <summary>
    /// Has the runtime compile now what the first steps of a world would wait for: it makes small worlds of its own with shapes, joints and
    /// a bullet, steps them some times and forgets them. In a process that compiles as it goes this takes some half a second, once; called
    /// again, and in one that was published as native code, some ten milliseconds. Worlds that exist are not touched, and what they do
    /// stays the same to the last bit. It may be called from any thread, while others step worlds of theirs:
    /// <c>Task.Run(b2World.WarmUp)</c> while a level loads. (An addition to the original.)
    /// </summary>
    /// <exception cref="PlatformNotSupportedException"><c>DOTNET_MaxVectorTBitWidth</c> asks for vectors of 512 bits, and the processor has
    /// them.</exception>
    public static void WarmUp() => WarmUpWorld.Run();

    /// <summary>
    /// What it throws comes out after the step as well: before what a listener threw it would hide that until the next one.
    /// </summary>
    private void DrawKept()
    {
        try
        {
            DrawDebugData();
        }
        catch (Exception exception)
        {
            Engine.Keep(exception);
        }
    }

    private void FreezeOutside()
    {
        for (b2Body? b = _bodies; b is not null; b = b.Next)
        {
            if (b.Link.IsStatic
                || b.Link.IsFrozen
                || b.IsSleeping()
                || (Engine.IsInside(b) && !Engine.World.BodyStage.IsQuarantined(b.Link.Index)))
            {
                continue;
            }

            b.Freeze();
            try
            {
                BoundaryListener?.Violation(b);
            }
            catch (Exception exception)
            {
                Engine.Keep(exception);
            }
        }
    }

    private void CutSpeeds(float dt)
    {
        for (b2Body? b = _bodies; b is not null; b = b.Next)
        {
            if (b.IsDynamic())
            {
                b.Link.CutSpeed(Engine.Gravity, dt, b2Settings.b2_maxLinearVelocity, b2Settings.b2_maxAngularVelocity);
            }
        }
    }

    private void SlowDragged()
    {
        const float Kept = 0.98f;
        for (b2Joint? joint = _joints; joint is not null; joint = joint.Next)
        {
            if (joint is b2MouseJoint)
            {
                joint.GetBody2().Link.Spin *= Kept;
            }
        }
    }
}
