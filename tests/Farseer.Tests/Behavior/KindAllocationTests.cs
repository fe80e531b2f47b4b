using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Behavior;

/// <summary>A warm simulation with every kind of joint, spring and controller at work allocates nothing.</summary>
public class KindAllocationTests
{
    private const int WarmSteps = 600;
    private const int CountedSteps = 400;
    private const float Apart = 150;

    [Fact]
    public void WarmUpdates_WithEveryKindActive_AllocateNothing()
    {
        // A first run compiles every method that the second one will use.
        Count(Kinds.All);

        (long bytes, World world) = Count(Kinds.All);

        Assert.Equal(0, bytes);
        world.AssertActive();
    }

    /// <summary>
    /// One kind at a time, with the reading of what it shows: a sum of zeros hides none that another one's memory covers.
    /// </summary>
    [Theory]
    [MemberData(nameof(EveryKind))]
    public void WarmUpdates_WithOneKindActive_AllocateNothing(string kind)
    {
        Count([kind]);

        Assert.Equal(0, Count([kind]).Bytes);
    }

    public static TheoryData<string> EveryKind => new(Kinds.All);

    private static (long Bytes, World World) Count(IEnumerable<string> kinds)
    {
        var world = new World(kinds);
        world.Run(WarmSteps);
        long before = GC.GetAllocatedBytesForCurrentThread();
        world.Run(CountedSteps);
        return (GC.GetAllocatedBytesForCurrentThread() - before, world);
    }

    /// <summary>A pair of boxes for each kind, kicked again and again so that no kind comes to rest.</summary>
    private sealed class World
    {
        private readonly PhysicsSimulator _simulator = Falling();
        private readonly List<Kinds.Pair> _pairs = [];
        private readonly List<object> _items = [];
        private float _seen;

        public World(IEnumerable<string> kinds)
        {
            Body floor = BodyFactory.Instance.CreateRectangleBody(_simulator, 10_000, 20, 1);
            floor.IsStatic = true;
            floor.Position = new Vector2(4000, 10);
            GeomFactory.Instance.CreateRectangleGeom(_simulator, floor, 10_000, 20);
            float x = 0;
            foreach (string kind in kinds)
            {
                var pair = new Kinds.Pair(_simulator, new Vector2(x, -30));
                pair.B.IsAutoIdle = kind == nameof(InactivityController);
                object item = Kinds.Make(kind, pair);
                Kinds.Add(_simulator, item);
                _pairs.Add(pair);
                _items.Add(item);
                x += Apart;
            }
        }

        public void Run(int steps)
        {
            for (int step = 0; step < steps; step++)
            {
                if (step % 50 == 0)
                {
                    Kick();
                }

                _simulator.Update(Step);
                Read();
            }
        }

        /// <summary>Nothing broke, was disposed, or lost its bodies, and each joint and spring has an effect.</summary>
        public void AssertActive()
        {
            foreach (object item in _items)
            {
                Assert.True(Kinds.Holds(_simulator, item), item.GetType().Name);
                Assert.True(
                    item is Joint { Enabled: true } or Spring { Enabled: true } or Controller { Enabled: true }, item.GetType().Name);
            }

            Assert.True(float.IsFinite(_seen) && _seen != 0);
        }

        private void Kick()
        {
            for (int i = 0; i < _pairs.Count; i++)
            {
                Kinds.Pair pair = _pairs[i];
                if (pair.A.Enabled && pair.B.Enabled)
                {
                    pair.A.ApplyImpulse(new Vector2(4, -8));
                    pair.B.ApplyImpulse(new Vector2(-4, -16));
                    pair.B.ApplyAngularImpulse(100);
                }

                if (_items[i] is ExplosionController blast)
                {
                    blast.Explode(pair.A.Position + new Vector2(0, 20), 100, 20);
                }
            }
        }

        private void Read()
        {
            for (int i = 0; i < _items.Count; i++)
            {
                _seen += _items[i] switch
                {
                    Joint joint => joint.JointError + joint.ReactionForce.X + joint.ReactionTorque,
                    Spring spring => spring.SpringError,
                    WaveController wave => wave.CurrentWave![1],
                    _ => _pairs[i].A.Position.X,
                };
            }
        }
    }
}
