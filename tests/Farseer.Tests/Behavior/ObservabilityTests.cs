using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Diagnostics.Metrics;
using System.Diagnostics.Tracing;
using System.Linq;
using System.Numerics;
using System.Reflection;
using System.Runtime.Versioning;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary>Tests that listen to the whole process: they run alone, and what they cost nobody else pays.</summary>
[CollectionDefinition(nameof(ProcessWideListeners), DisableParallelization = true)]
public class ProcessWideListeners
{
}

[Collection(nameof(ProcessWideListeners))]
public class ObservabilityTests
{
    private const string Source = "Farseer.Physics";
    private const int Boxes = 17;
    private const int Steps = 30;
    private const float Dt = 1f / 60;

    private static readonly bool _hasMeter =
        !typeof(PhysicsSimulator).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName
        .Contains("NETStandard", StringComparison.Ordinal);

    [Fact]
    public void Step_HeardByAnEventListener_TellsItsNumbersAndTimes()
    {
        using var listener = new Listener();
        PhysicsSimulator simulator = Make();

        Run(simulator);

        EventWrittenEventArgs[] steps = listener.Of("Step", Boxes + 1);
        Assert.Equal(Steps, steps.Length);
        EventWrittenEventArgs last = steps[^1];
        Assert.Equal((long)Steps, Payload(last, "step"));
        Assert.Equal(simulator.ContactCount, Payload(last, "contacts"));
        Assert.Equal(0, Payload(last, "sleeping"));
        Assert.Equal(simulator.Iterations, Payload(last, "substeps"));
        Assert.Equal(false, Payload(last, "missedBudget"));
        Assert.True(steps.Sum(s => (double)Payload(s, "solve")!) > 0);
        Assert.True(steps.Sum(s => (double)Payload(s, "broadPhase")!) > 0);
        Assert.All(steps, s => Assert.InRange((double)Payload(s, "narrowPhase")!, 0, 10));
    }

    [Fact]
    public void Rollback_HeardByAnEventListener_IsTold()
    {
        using var listener = new Listener();
        PhysicsSimulator simulator = Make();
        Run(simulator);
        PhysicsSimulatorState state = simulator.Capture();
        Run(simulator);

        simulator.Restore(state);

        EventWrittenEventArgs told = Assert.Single(listener.Of("Rollback"));
        Assert.Equal(2L * Steps, Payload(told, "step"));
        Assert.True((int)Payload(told, "bytes")! > 0);
    }

    [Fact]
    public void Step_BeyondItsBudget_IsToldAsMissed()
    {
        using var listener = new Listener();
        PhysicsSimulator simulator = Make();
        simulator.ErrorBudget = ErrorBudget.OfLength(1e-9f, 1);

        Run(simulator);

        Assert.Contains(listener.Of("Step", Boxes + 1), s => (bool)Payload(s, "missedBudget")!);
    }

    [Fact]
    public void Step_HeardByAMeterListener_IsMeasured()
    {
        var doubles = new ConcurrentQueue<(string Name, double Value, string? Phase)>();
        var whole = new ConcurrentQueue<(string Name, int Value)>();
        long rollbacks = 0;
        using var listener = new MeterListener();
        listener.InstrumentPublished = (instrument, l) =>
        {
            if (instrument.Meter.Name == Source)
            {
                l.EnableMeasurementEvents(instrument);
            }
        };
        listener.SetMeasurementEventCallback<double>((i, value, tags, _) =>
            doubles.Enqueue((i.Name, value, tags.Length > 0 ? (string?)tags[0].Value : null)));
        listener.SetMeasurementEventCallback<int>((i, value, _, _) => whole.Enqueue((i.Name, value)));
        listener.SetMeasurementEventCallback<long>((i, value, _, _) => rollbacks += i.Name == "farseer.rollbacks" ? value : 0);
        listener.Start();
        PhysicsSimulator simulator = Make();
        PhysicsSimulatorState state = simulator.Capture();

        Run(simulator);
        simulator.Restore(state);

        if (!_hasMeter)
        {
            Assert.Empty(doubles);
            return;
        }

        double[] durations = doubles.Where(d => d.Name == "farseer.step.duration").Select(d => d.Value).ToArray();
        Assert.Equal(Steps, durations.Length);
        double phases = doubles.Where(d => d.Name == "farseer.step.phase.duration").Sum(d => d.Value);
        Assert.Equal(durations.Sum(), phases, 9);
        Assert.Equal(9, doubles.Where(d => d.Phase != null).Select(d => d.Phase).Distinct().Count());
        Assert.All(whole.Where(w => w.Name == "farseer.step.bodies"), w => Assert.Equal(Boxes + 1, w.Value));
        Assert.Contains(whole, w => w.Name == "farseer.step.contacts" && w.Value > 0);
        Assert.Equal(1, rollbacks);
    }

    [Fact]
    public void Step_HeardAndUnheard_HasTheSameBitsAndUnheardAllocatesNothing()
    {
        PhysicsSimulator unheard = Make();
        Run(unheard);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Run(unheard);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);

        using var listener = new Listener();
        PhysicsSimulator heard = Make();
        Run(heard);
        Run(heard);

        Assert.Equal(unheard.StateHash(), heard.StateHash());
    }

    private static PhysicsSimulator Make()
    {
        var simulator = new PhysicsSimulator(new Vector2(0, 10));
        Body floor = BodyFactory.Instance.CreateRectangleBody(simulator, 80, 1, 1);
        floor.IsStatic = true;
        GeomFactory.Instance.CreateRectangleGeom(simulator, floor, 80, 1);
        for (int i = 0; i < Boxes; i++)
        {
            Body box = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
            box.Position = new Vector2((2 * i) - Boxes, -1.05f);
            GeomFactory.Instance.CreateRectangleGeom(simulator, box, 1, 1);
        }

        return simulator;
    }

    private static void Run(PhysicsSimulator simulator)
    {
        for (int i = 0; i < Steps; i++)
        {
            simulator.Update(Dt);
        }
    }

    private static object? Payload(EventWrittenEventArgs told, string name) => told.Payload![told.PayloadNames!.IndexOf(name)];

    private sealed class Listener : EventListener
    {
        private readonly ConcurrentQueue<EventWrittenEventArgs> _told = new ConcurrentQueue<EventWrittenEventArgs>();

        public EventWrittenEventArgs[] Of(string name) => _told.Where(t => t.EventName == name).ToArray();

        public EventWrittenEventArgs[] Of(string name, int bodies) => Of(name).Where(t => bodies.Equals(Payload(t, "bodies"))).ToArray();

        protected override void OnEventSourceCreated(EventSource eventSource)
        {
            if (eventSource.Name == Source)
            {
                EnableEvents(eventSource, EventLevel.Verbose);
            }
        }

        // The base class may call before there is a queue.
        protected override void OnEventWritten(EventWrittenEventArgs eventData) => _told?.Enqueue(eventData);
    }
}
