using System;
using System.Threading;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Interfaces;

namespace Farseer.Hunt.Farseer;

/// <summary>A joint of a user's own, which does nothing but call back.</summary>
public sealed class OwnJoint : Joint, ISavedState
{
    public int StateSize => 0;

    public void SaveState(Span<byte> destination)
    {
    }

    public void RestoreState(ReadOnlySpan<byte> source)
    {
    }

    public event Action PreStepping = delegate { };

    public event Action Updating = delegate { };

    public override void Validate()
    {
    }

    public override void PreStep(float inverseDt) => PreStepping();

    public override void Update() => Updating();
}

/// <summary>A spring of a user's own, which does nothing but call back.</summary>
public sealed class OwnSpring : Spring, ISavedState
{
    public int StateSize => 0;

    public void SaveState(Span<byte> destination)
    {
    }

    public void RestoreState(ReadOnlySpan<byte> source)
    {
    }

    public event Action Updating = delegate { };

    public override void Validate()
    {
    }

    public override void Update(float dt) => Updating();
}

/// <summary>A controller of a user's own, which does nothing but call back.</summary>
public sealed class OwnController : Controller, ISavedState
{
    public int StateSize => 0;

    public void SaveState(Span<byte> destination)
    {
    }

    public void RestoreState(ReadOnlySpan<byte> source)
    {
    }

    public event Action Updating = delegate { };

    public override void Validate()
    {
    }

    public override void Update(float dt) => Updating();
}

/// <summary>Threads of a host.</summary>
public sealed class OwnScheduler : IStepScheduler
{
    public void Start(int count, Action help)
    {
        for (int i = 0; i < count; i++)
        {
            ThreadPool.QueueUserWorkItem(_ => help());
        }
    }
}
