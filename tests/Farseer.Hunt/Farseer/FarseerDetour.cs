using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Hunt.Running;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Hunt.Farseer;

/// <content>Captures and restores.</content>
internal sealed partial class FarseerObserver
{
    private readonly ConditionalWeakTable<Geom, object> _numbers = new();
    private readonly PhysicsSimulatorState _state = new();
    private readonly PhysicsSimulatorState _again = new();
    private RollbackBuffer? _buffer;

    protected override bool TakeDetour(object world, Random random)
    {
        var simulator = (PhysicsSimulator)world;
        try
        {
            simulator.Capture(_state);
        }
        catch (ObjectDisposedException)
        {
            return false;
        }

        // What has not changed since it was captured before is not written anew.
        if (!_state.IsSameAs(simulator.Capture()))
        {
            Problems.Add(("a state that is used again is another one than a new one", ""));
        }

        RollbackBuffer buffer = Buffer(simulator);
        long frame = buffer.Push();
        for (int i = 1 + random.Next(6); i > 0; i--)
        {
            try
            {
                Mischief(simulator, random);
            }
            catch (Exception exception) when (exception is ArgumentException or InvalidOperationException)
            {
                // As refused as anywhere.
            }
        }

        if (random.Next(2) == 0)
        {
            simulator.Restore(_state);
        }
        else
        {
            for (int i = random.Next(3); i > 0; i--)
            {
                buffer.Push();
            }

            buffer.Rewind(frame);
        }

        simulator.Capture(_again);
        if (!_state.IsSameAs(_again))
        {
            Problems.Add(("a restored state is another one", _state.Compare(_again, 1).ToString()));
        }

        return true;
    }

    private RollbackBuffer Buffer(PhysicsSimulator simulator) =>
        _buffer is not null && ReferenceEquals(_buffer.Simulator, simulator) ? _buffer : _buffer = new RollbackBuffer(simulator, 6);

    protected override object? Traced(object world)
    {
        try
        {
            var state = new PhysicsSimulatorState();
            state.BeginTrace();
            ((PhysicsSimulator)world).Capture(state);
            return state;
        }
        catch (ObjectDisposedException)
        {
            return null;
        }
    }

    protected override IEnumerable<string> Differences(object state, object other) =>
        ((PhysicsSimulatorState)state).Compare((PhysicsSimulatorState)other, MostDifferences).Differences.Select(d => d.ToString());

    private static void Mischief(PhysicsSimulator simulator, Random random)
    {
        Body? body = simulator.BodyList.Count > 0 ? simulator.BodyList[random.Next(simulator.BodyList.Count)] : null;
        Geom? geom = simulator.GeomList.Count > 0 ? simulator.GeomList[random.Next(simulator.GeomList.Count)] : null;
        switch (random.Next(12))
        {
            case 0 when body is not null:
                simulator.Remove(body);
                break;
            case 1 when body is not null:
                body.Dispose();
                break;
            case 2 when geom is not null:
                simulator.Remove(geom);
                break;
            case 3 when geom is not null:
                geom.Dispose();
                break;
            case 4 when simulator.JointList.Count > 0:
                simulator.Remove(simulator.JointList[random.Next(simulator.JointList.Count)]);
                break;
            case 5:
                Body added = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, 1);
                added.Position = new Vector2(random.Next(-5, 5), random.Next(1, 20));
                GeomFactory.Instance.CreateRectangleGeom(simulator, added, 1, 1);
                break;
            case 6:
                simulator.Gravity = new Vector2(3, 5);
                break;
            case 7 when body is not null:
                body.LinearVelocity = new Vector2(random.Next(-20, 20), random.Next(-20, 20));
                body.IsStatic = random.Next(3) == 0;
                break;
            case 8 when random.Next(8) == 0:
                simulator.Clear();
                break;
            case 9 when geom is not null && body is not null:
                geom.SetBody(body);
                break;
            case 10 when geom is not null:
                geom.SetVertices(Vertices.CreateRectangle(0.7f, 0.4f));
                geom.FrictionCoefficient = 0.1f;
                break;
        }

        for (int i = random.Next(5); i > 0; i--)
        {
            simulator.Update(1f / 60);
        }
    }

    private void Tell(ulong what, Geom a, Geom b)
    {
        Told(what);
        Told(Number(a));
        Told(Number(b));
    }

    private ulong Number(Geom geom) => _numbers.TryGetValue(geom, out object? number) ? (ulong)(int)number : ulong.MaxValue;
}
