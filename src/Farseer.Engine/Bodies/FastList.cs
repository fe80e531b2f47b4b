using System;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Bodies;

/// <summary>The bodies that moved by more than their size in a step, with their states at its start.</summary>
[NotState(Why.OfOneStep)]
internal sealed unsafe class FastList
{
    private FastMotion* _motions;
    private int _capacity;

    public int Count { get; private set; }

    public ref FastMotion this[int position] => ref _motions[position];

    /// <summary>
    /// Makes room for more of them behind those that there are. Whoever fills it may go on by adding some of these: what is added is
    /// written to where it stands or before that.
    /// </summary>
    /// <param name="scratch">Where they are until the step ends.</param>
    /// <param name="more">How many.</param>
    public FastMotion* MakeRoom(Scratch scratch, int more)
    {
        if (Count + more > _capacity)
        {
            _capacity = Math.Max(Count + more, Count == 0 ? 0 : 2 * _capacity);
            FastMotion* motions = scratch.Take<FastMotion>(_capacity);
            for (int i = 0; i < Count; i++)
            {
                motions[i] = _motions[i];
            }

            _motions = motions;
        }

        return _motions + Count;
    }

    /// <summary>The step is over, and with it the scratch memory.</summary>
    public void End()
    {
        Count = 0;
        _motions = null;
        _capacity = 0;
    }

    /// <summary>For a body that has flown: foreseen to be fast, or fast by what came since.</summary>
    public static bool IsFast(BodyStore bodies, int body, in BodyPose before)
    {
        if ((bodies.Flags[body] & BodyFlags.Fast) != 0)
        {
            return true;
        }

        BodySize size = bodies.Size[body];
        BodyPose pose = bodies.Pose[body];
        return Math.Abs(pose.X - before.X) + Math.Abs(pose.Y - before.Y) + (Math.Abs(pose.Angle - before.Angle) * size.Reach) > size.Extent;
    }

    /// <summary>Whether a fast body is to be looked after.</summary>
    public static bool IsLookedAfter(BodyStore bodies, int body) => (bodies.Flags[body] & (BodyFlags.Discrete | BodyFlags.Kinematic)) == 0;

    /// <summary>How a body began its step.</summary>
    public static FastMotion Begin(int body, in BodyPose start, in BodyState state, bool isFree) => new FastMotion
    {
        X = start.X,
        Y = start.Y,
        Angle = start.Angle,
        VelocityX = state.LinearVelocity.X,
        VelocityY = state.LinearVelocity.Y,
        AngularVelocity = state.AngularVelocity,
        Body = body,
        Free = isFree ? 1 : 0,
    };

    /// <summary>Notes a body that is to be looked after.</summary>
    public void Add(in FastMotion motion) => _motions[Count++] = motion;
}
