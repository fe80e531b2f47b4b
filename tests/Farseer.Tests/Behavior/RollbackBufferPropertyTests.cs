using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Interfaces;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Whatever happens in a world, a frame of a buffer is what a capture of its own has.</summary>
public sealed class RollbackBufferPropertyTests
{
    private const float Dt = 1f / 60;

    /// <summary>
    /// Things come and go, fall asleep, are joined, have handlers, and pushes fail half way: each frame that is gone back to, from any
    /// depth, is bit for bit the state that was captured by itself.
    /// </summary>
    [Theory]
    [InlineData(1, 3)]
    [InlineData(2, 10)]
    [InlineData(3, 40)]
    [InlineData(4, 90)]
    [InlineData(5, 200)]
    [InlineData(6, 200)]
    public void Rewind_InARandomWorld_GivesTheStateThatWasCapturedByItself(int seed, int frames)
    {
        var random = new Random(seed);
        using var simulator = new PhysicsSimulator(new Vector2(0, -10)) { AllowSleep = random.Next(3) > 0 };
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 60, 1, 1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 60, 1);
        var balky = new Balky();
        simulator.Add(balky);
        simulator.Update(Dt);
        RollbackBuffer buffer = random.Next(2) == 0
            ? new RollbackBuffer(simulator, frames) : RollbackBuffer.WithBudget(simulator, 20_000L * frames);
        var states = new Dictionary<long, PhysicsSimulatorState>();
        int rewinds = 0;
        for (int round = 0; round < 60; round++)
        {
            for (int i = 1 + random.Next(Math.Min(frames, 30)); i > 0; i--)
            {
                Happen(simulator, random);
                balky.Refuses = random.Next(12) == 0;
                if (balky.Refuses)
                {
                    Assert.Throws<FormatException>(() => buffer.Push());
                    balky.Refuses = false;
                    continue;
                }

                states[buffer.Push()] = simulator.Capture();
            }

            for (int i = random.Next(3); i > 0 && buffer.Count > 0; i--)
            {
                long frame = random.NextInt64(buffer.OldestFrame, buffer.NewestFrame + 1);
                buffer.Rewind(frame);
                PhysicsSimulatorState now = simulator.Capture();
                Assert.True(now.IsSameAs(states[frame]), $"round {round}, frame {frame}: {now.Compare(states[frame], 3)}");
                rewinds++;
            }
        }

        Assert.True(rewinds > 20);
    }

    private static void Happen(PhysicsSimulator simulator, Random random)
    {
        int count = simulator.BodyList.Count;
        Body body = simulator.BodyList[random.Next(count)];
        switch (random.Next(14))
        {
            case < 4 when count < 150:
                Add(simulator, random, 1 + random.Next(random.Next(10) == 0 ? 40 : 3));
                break;
            case 4 when !body.IsStatic:
                simulator.Remove(body.GeomAt(0));
                simulator.Remove(body);
                break;
            case 5:
                Body other = simulator.BodyList[random.Next(count)];
                if (other != body)
                {
                    simulator.Add(new RevoluteJoint(body, other, body.Position));
                }

                break;
            case 6 when simulator.JointList.Count > 0:
                simulator.Remove(simulator.JointList[random.Next(simulator.JointList.Count)]);
                break;
            case 7:
                body.ApplyImpulse(new Vector2(random.Next(-5, 6), random.Next(9)));
                break;
            case 8:
                body.Awake = !body.Awake;
                break;
            case 9 when body.GeomCount > 0:
                body.GeomAt(0).OnCollision = random.Next(2) == 0 ? null : (a, b, contacts) => true;
                body.GeomAt(0).FrictionCoefficient = random.NextSingle();
                break;
            case 10 when random.Next(10) == 0:
                while (simulator.JointList.Count > 0)
                {
                    simulator.Remove(simulator.JointList[0]);
                    simulator.Update(0);
                }

                break;
        }

        simulator.Update(Dt);
    }

    private static void Add(PhysicsSimulator simulator, Random random, int bodies)
    {
        for (; bodies > 0; bodies--)
        {
            Body body = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
            body.Position = new Vector2((40 * random.NextSingle()) - 20, 1 + (20 * random.NextSingle()));
            GeomFactory.Instance.CreateRectangleGeom(simulator, body, 1, 1);
        }
    }

    /// <summary>Sometimes throws while it is saved.</summary>
    private sealed class Balky : Controller, ISavedState
    {
        private int _count;

        public bool Refuses { get; set; }

        public int StateSize => sizeof(int);

        public override void Validate()
        {
        }

        public override void Update(float dt) => _count++;

        public void SaveState(Span<byte> destination)
        {
            BitConverter.TryWriteBytes(destination, _count);
            if (Refuses)
            {
                throw new FormatException();
            }
        }

        public void RestoreState(ReadOnlySpan<byte> source) => _count = BitConverter.ToInt32(source);
    }
}
