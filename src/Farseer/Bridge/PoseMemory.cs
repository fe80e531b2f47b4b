using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Where bodies were when the last update began, by their place in the world. There is none unless somebody draws between updates.
/// </summary>
internal sealed class PoseMemory
{
    private BodyPose[] _before = [];

    public bool IsOn { get; set; }

    public void Visit(StateStream s)
    {
        IsOn = s.Value(IsOn);
        s.Sized(ref _before);
    }

    /// <summary>Keeps the poses of all bodies.</summary>
    public unsafe void Keep(World world)
    {
        if (IsOn)
        {
            int end = world.Bodies.Ids.End;
            if (_before.Length < end)
            {
                _before = new BodyPose[Math.Max(end, 2 * _before.Length)];
            }

            new ReadOnlySpan<BodyPose>(world.Bodies.Pose.Pointer, end).CopyTo(_before);
        }
    }

    /// <summary>A body was put where it is: it did not come from where it was.</summary>
    public void Put(int place, in BodyPose pose)
    {
        if (IsOn)
        {
            if (_before.Length <= place)
            {
                Array.Resize(ref _before, Math.Max(place + 1, 2 * _before.Length));
            }

            _before[place] = pose;
        }
    }

    /// <summary>Where a body was; where it is, if that is not known.</summary>
    public BodyPose Before(int place, in BodyPose now) => IsOn && place < _before.Length ? _before[place] : now;
}
