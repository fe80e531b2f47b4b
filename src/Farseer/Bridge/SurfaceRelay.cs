using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Tells the engine what the surfaces of a pair are: by segment, by rule, and as the user's mixer says.</summary>
internal sealed class SurfaceRelay : IPairSurfaces
{
    private readonly PhysicsSimulator _simulator;
    [NotState(Why.Elsewhere)]
    private readonly ObjectTable _table;

    public SurfaceRelay(PhysicsSimulator simulator, ObjectTable table)
    {
        _simulator = simulator;
        _table = table;
    }

    public MaterialMixer? Mixer { get; set; }

    public bool JudgesAll => Mixer is not null;

    public void Visit(StateStream s) => Mixer = s.Reference(Mixer);

    public void Describe(int colliderA, int colliderB, ref PairSurface surface)
    {
        Geom? a = _table.Geom(colliderA);
        Geom? b = _table.Geom(colliderB);
        if (a is null || b is null)
        {
            return;
        }

        SurfaceMaterial first = a.MaterialOf(surface.SegmentA);
        SurfaceMaterial second = b.MaterialOf(surface.SegmentB);
        var mixed = new SurfaceMaterial
        {
            Friction = a.HasSegments || b.HasSegments ? Mix(first.Friction, second.Friction) : surface.Friction,
            Restitution = a.HasSegments || b.HasSegments ? MixBounce(first.Restitution, second.Restitution) : surface.Restitution,
            Speed = first.Speed + second.Speed,
            RollingResistance = Math.Max(first.RollingResistance, second.RollingResistance),
        };
        if (Mixer is not null)
        {
            mixed = Ask(a, b, mixed);
        }

        surface.Friction = mixed.Friction;
        surface.Restitution = mixed.Restitution;
        surface.Speed = mixed.Speed;
        surface.RollingArm = mixed.RollingResistance;
    }

    private SurfaceMaterial Ask(Geom a, Geom b, SurfaceMaterial mixed)
    {
        SurfaceMaterial before = mixed;
        try
        {
            if (a.Id < b.Id)
            {
                Mixer!(a, b, ref mixed);
            }
            else
            {
                Mixer!(b, a, ref mixed);
            }

            return mixed;
        }
        catch (Exception exception)
        {
            _simulator.Relay.Keep(exception);
            return before;
        }
    }

    private float Mix(float a, float b) => _simulator.FrictionType switch
    {
        FrictionType.Minimum => Math.Min(a, b),
        FrictionType.GeometricMean => (float)Math.Sqrt(a * b),
        FrictionType.Maximum => Math.Max(a, b),
        FrictionType.Product => a * b,
        _ => (a + b) * 0.5f,
    };

    private float MixBounce(float a, float b) => _simulator.RestitutionType switch
    {
        RestitutionType.Minimum => Math.Min(a, b),
        RestitutionType.Maximum => Math.Max(a, b),
        RestitutionType.Product => a * b,
        _ => (a + b) * 0.5f,
    };
}
