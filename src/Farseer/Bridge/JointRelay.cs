using System;
using System.Collections.Generic;
using Farseer.Engine.Joints;
using Farseer.Engine.Simulation;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>
/// Lets the solver call the joints that a user wrote, and tells joints that they broke. An exception from them is kept and thrown
/// when the step is complete, as those of handlers are.
/// </summary>
internal sealed class JointRelay : IUserJoints
{
    private readonly EventRelay _events;
    [NotState(Why.Derived)]
    private readonly List<Joint?> _jointOf = new List<Joint?>();

    public JointRelay(EventRelay events, World world)
    {
        _events = events;
        world.UserJoints = this;
    }

    /// <summary>The joints that users wrote, in the order in which they were added.</summary>
    public List<Joint> Written { get; } = new List<Joint>();

    public bool Any => Written.Count > 0;

    /// <summary>Notes which joint an index of the engine stands for.</summary>
    public void Set(int index, Joint? joint)
    {
        while (_jointOf.Count <= index)
        {
            _jointOf.Add(null);
        }

        _jointOf[index] = joint;
    }

    /// <summary>The joint that an index of the engine stands for, if there is one.</summary>
    public Joint? Find(int index) => index < _jointOf.Count ? _jointOf[index] : null;

    public void Prepare(float inverseSubstep)
    {
        for (int i = 0; i < Written.Count; i++)
        {
            if (Written[i].Enabled && !Written[i].IsDisposed)
            {
                try
                {
                    Written[i].PreStep(inverseSubstep);
                }
                catch (Exception exception)
                {
                    _events.Keep(exception);
                }
            }
        }
    }

    public void Solve()
    {
        for (int i = 0; i < Written.Count; i++)
        {
            if (Written[i].Enabled && !Written[i].IsDisposed)
            {
                try
                {
                    Written[i].Update();
                }
                catch (Exception exception)
                {
                    _events.Keep(exception);
                }
            }
        }
    }

    public void Broke(int joint)
    {
        try
        {
            _jointOf[joint]?.Break();
        }
        catch (Exception exception)
        {
            _events.Keep(exception);
        }
    }

    /// <summary>Nothing is anywhere.</summary>
    public void ClearTable()
    {
        for (int i = 0; i < _jointOf.Count; i++)
        {
            _jointOf[i] = null;
        }
    }
}
