using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

public class WorldBatchTests
{
    private const int Worlds = 7;
    private const int ActionSize = 1;
    private const int ObservationSize = 3;
    private const int Steps = 90;
    private const float Dt = 1f / 60;

    [Theory]
    [InlineData(2)]
    [InlineData(5)]
    public void Step_ByAnyNumberOfWorkers_GivesTheSameBits(int workers)
    {
        using WorldBatch one = Make(1);
        using WorldBatch several = Make(workers);

        float[] seenByOne = Run(one, 1);
        float[] seenBySeveral = Run(several, 1);

        Assert.Equal(seenByOne, seenBySeveral);
        Assert.Equal(Hashes(one), Hashes(several));
        Assert.Equal(Worlds, new HashSet<ulong>(Hashes(one)).Count);
    }

    [Fact]
    public void Step_OfSeveralUpdates_IsThatOfAWorldAlone()
    {
        const int Updates = 3;
        using WorldBatch batch = Make(2);
        float[] seen = Run(batch, Updates);

        var alone = new Cart(4);
        for (int step = 0; step < Steps; step++)
        {
            for (int i = 0; i < Updates; i++)
            {
                alone.Act(new[] { Action(step, 4) });
                alone.Simulator.Update(Dt);
            }
        }

        var expected = new float[ObservationSize];
        alone.Observe(expected);
        Assert.Equal(alone.Simulator.StateHash(), batch[4].Simulator.StateHash());
        Assert.Equal(expected, seen[(4 * ObservationSize)..(5 * ObservationSize)]);
    }

    [Fact]
    public void Reset_OfSome_TakesThemAndNoOthersBack()
    {
        using WorldBatch batch = Make(3);
        var first = new float[Worlds * ObservationSize];
        batch.Observe(first);
        float[] last = Run(batch, 1);
        var which = new bool[Worlds];
        which[1] = which[5] = true;

        batch.Reset(which);

        var now = new float[last.Length];
        batch.Observe(now);
        for (int i = 0; i < now.Length; i++)
        {
            Assert.Equal(which[i / ObservationSize] ? first[i] : last[i], now[i]);
        }

        Assert.Equal(1, ((Cart)batch[5]).Resets);
        Assert.Equal(0, ((Cart)batch[0]).Resets);
    }

    [Fact]
    public void Step_AfterReset_RepeatsAllBits()
    {
        using WorldBatch batch = Make(2);
        Run(batch, 1);
        ulong[] hashes = Hashes(batch);

        batch.ResetAll();
        batch.Reset(3);
        Run(batch, 1);

        Assert.Equal(hashes, Hashes(batch));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void Step_OnceWarm_AllocatesNothing(int workers)
    {
        using WorldBatch batch = Make(workers);
        var actions = new float[Worlds * ActionSize];
        var seen = new float[Worlds * ObservationSize];
        long allocated = 0;
        for (int round = 0; round < 3; round++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int step = 0; step < Steps; step++)
            {
                batch.Step(Dt, actions, seen);
            }

            batch.ResetAll();
            batch.Reset(2);
            allocated = GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.Equal(0, allocated);
    }

    [Fact]
    public void Step_WhereWorldsThrow_StepsTheOthersAndThrowsTheFirst()
    {
        using WorldBatch batch = Make(3);
        ((Cart)batch[5]).Failure = new InvalidOperationException("five");
        ((Cart)batch[2]).Failure = new InvalidOperationException("two");
        var seen = new float[Worlds * ObservationSize];

        InvalidOperationException thrown = Assert.Throws<InvalidOperationException>(() => batch.Step(Dt, new float[Worlds], seen));

        Assert.Equal("two", thrown.Message);
        Assert.Equal(0, batch[2].Simulator.StepCount);
        Assert.Equal(1, batch[6].Simulator.StepCount);
        ((Cart)batch[2]).Failure = null;
        ((Cart)batch[5]).Failure = null;
        batch.Step(Dt, new float[Worlds], seen);
        Assert.Equal(1, batch[2].Simulator.StepCount);
    }

    [Fact]
    public void Step_CalledByAWorld_Throws()
    {
        using WorldBatch batch = Make(2);
        ((Cart)batch[0]).Acted = () => batch.Step(Dt, new float[Worlds], new float[Worlds * ObservationSize]);

        Assert.Throws<InvalidOperationException>(() => batch.Step(Dt, new float[Worlds], new float[Worlds * ObservationSize]));
    }

    [Fact]
    public void Step_BadInput_NamesTheArgumentAndStepsNothing()
    {
        using WorldBatch batch = Make(2);
        var actions = new float[Worlds];
        var seen = new float[Worlds * ObservationSize];

        Assert.Equal("actions", Assert.Throws<ArgumentException>(() => batch.Step(Dt, new float[Worlds + 1], seen)).ParamName);
        Assert.Equal("observations", Assert.Throws<ArgumentException>(() => batch.Step(Dt, actions, new float[1])).ParamName);
        Assert.Equal("dt", Assert.Throws<ArgumentOutOfRangeException>(() => batch.Step(float.NaN, actions, seen)).ParamName);
        Assert.Equal("updates", Assert.Throws<ArgumentOutOfRangeException>(() => batch.Step(Dt, actions, seen, 0)).ParamName);
        Assert.Equal("index", Assert.Throws<ArgumentOutOfRangeException>(() => batch.Reset(Worlds)).ParamName);
        Assert.Equal("which", Assert.Throws<ArgumentException>(() => batch.Reset(new bool[1])).ParamName);
        Assert.Equal(0, batch[0].Simulator.StepCount);
    }

    [Fact]
    public void Batch_OfOneSimulatorTwice_Throws()
    {
        var cart = new Cart(0);

        Assert.Equal("make", Assert.Throws<ArgumentException>(() => new WorldBatch(2, 1, 3, _ => cart)).ParamName);
        Assert.Equal("make", Assert.Throws<ArgumentException>(() => new WorldBatch(2, 1, 3, _ => null!)).ParamName);
        Assert.Equal("count", Assert.Throws<ArgumentOutOfRangeException>(() => new WorldBatch(0, 1, 3, i => new Cart(i))).ParamName);
    }

    [Fact]
    public void Step_Disposed_Throws()
    {
        WorldBatch batch = Make(2);
        Run(batch, 1);
        batch.Dispose();
        batch.Dispose();

        Assert.Throws<ObjectDisposedException>(() => batch.ResetAll());
    }

    private static WorldBatch Make(int workers) => new WorldBatch(Worlds, ActionSize, ObservationSize, i => new Cart(i), workers);

    private static float Action(int step, int world) => MathF.Sin((0.1f * step) + world);

    private static float[] Run(WorldBatch batch, int updates)
    {
        var actions = new float[Worlds * ActionSize];
        var seen = new float[Worlds * ObservationSize];
        for (int step = 0; step < Steps; step++)
        {
            for (int i = 0; i < Worlds; i++)
            {
                actions[i] = Action(step, i);
            }

            batch.Step(Dt, actions, seen, updates);
        }

        return seen;
    }

    private static ulong[] Hashes(WorldBatch batch)
    {
        var hashes = new ulong[batch.Count];
        for (int i = 0; i < hashes.Length; i++)
        {
            hashes[i] = batch[i].Simulator.StateHash();
        }

        return hashes;
    }

    private sealed class Cart : BatchedWorld
    {
        private const float Force = 20;

        private readonly Body _cart;

        public Cart(int index)
            : base(new PhysicsSimulator(new Vector2(0, 10)))
        {
            Body floor = BodyFactory.Instance.CreateRectangleBody(Simulator, 40, 1, 1);
            floor.IsStatic = true;
            GeomFactory.Instance.CreateRectangleGeom(Simulator, floor, 40, 1);
            _cart = BodyFactory.Instance.CreateRectangleBody(Simulator, 2, 1, 1);
            _cart.Position = new Vector2(index, -1.1f);
            GeomFactory.Instance.CreateRectangleGeom(Simulator, _cart, 2, 1);
            Body load = BodyFactory.Instance.CreateCircleBody(Simulator, 0.5f, 1);
            load.Position = new Vector2(index + 0.3f, -2.3f);
            GeomFactory.Instance.CreateCircleGeom(Simulator, load, 0.5f, 12);
        }

        public int Resets { get; private set; }

        public Exception? Failure { get; set; }

        public Action? Acted { get; set; }

        public override void Act(ReadOnlySpan<float> action)
        {
            Acted?.Invoke();
            if (Failure != null)
            {
                throw Failure;
            }

            _cart.ApplyForce(new Vector2(Force * action[0], 0));
        }

        public override void Observe(Span<float> observation)
        {
            observation[0] = _cart.Position.X;
            observation[1] = _cart.LinearVelocity.X;
            observation[2] = _cart.Rotation;
        }

        protected internal override void OnReset() => Resets++;
    }
}
