using Farseer.Engine.Simulation;
using Farseer.Engine.Springs;
using Farseer.Engine.Storage;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>What the engine was last told of a spring: when that changes, or ends, what the spring holds must wake.</summary>
internal sealed class SpringMemory
{
    private World? _world;
    private SpringDef _def;

    public void Tell(World world, in SpringDef def)
    {
        if (!def.IsSameAs(_def))
        {
            _def = def;
            _world = world;
            WakeEnds();
        }

        _world = world;
        world.ApplySpring(def);
    }

    /// <summary>The spring leaves: what it held wakes, and wakes again if it comes back.</summary>
    public void LetGo()
    {
        WakeEnds();
        _world = null;
        _def = default;
    }

    public void WakeEnds()
    {
        if (_world is { Sleep.AsleepCount: > 0 } world)
        {
            world.Sleep.WakeUp(_def.BodyA);
            world.Sleep.WakeUp(_def.BodyB);
        }
    }

    /// <summary>Writes, or reads, what later updates read of it.</summary>
    public void Visit(StateStream s)
    {
        s.Reference(ref _world);
        s.Value(ref _def);
    }

    /// <summary>Lets go of a world that is about to be another one.</summary>
    public void Forget()
    {
        _world = null;
        _def = default;
    }
}
