using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// What new bodies and geoms of a simulator begin with: the values that a factory gives to what it makes for the simulator. What is there
/// already keeps its values, and so does a copy of a body or a geom. What you make without a factory, or with a factory but without a
/// simulator, has the defaults of <see cref="Body"/> and <see cref="Geom"/>. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// simulator.Defaults.FrictionCoefficient = 0.5f;
/// simulator.Defaults.LinearDragCoefficient = 0;
/// simulator.Defaults.RotationalDragCoefficient = 0;
/// Body crate = BodyFactory.Instance.CreateRectangleBody(simulator, 1, 1, mass: 2);
/// Geom rough = GeomFactory.Instance.CreateRectangleGeom(simulator, crate, 1, 1);
/// </code>
/// </example>
public sealed class SimulatorDefaults
{
    private float _friction;
    private float _restitution;
    private float _linearDrag = Body.DefaultDrag;
    private float _rotationalDrag = Body.DefaultDrag;

    internal SimulatorDefaults()
    {
    }

    /// <summary><see cref="Geom.FrictionCoefficient"/> of new geoms; at least 0. Default 0.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float FrictionCoefficient
    {
        get => _friction;
        set => _friction = Require.NotNegative(value, nameof(FrictionCoefficient));
    }

    /// <summary><see cref="Geom.RestitutionCoefficient"/> of new geoms; at least 0. Default 0.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float RestitutionCoefficient
    {
        get => _restitution;
        set => _restitution = Require.NotNegative(value, nameof(RestitutionCoefficient));
    }

    /// <summary><see cref="Body.LinearDragCoefficient"/> of new bodies; at least 0. Default 0.001.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float LinearDragCoefficient
    {
        get => _linearDrag;
        set => _linearDrag = Require.NotNegative(value, nameof(LinearDragCoefficient));
    }

    /// <summary><see cref="Body.RotationalDragCoefficient"/> of new bodies; at least 0. Default 0.001.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float RotationalDragCoefficient
    {
        get => _rotationalDrag;
        set => _rotationalDrag = Require.NotNegative(value, nameof(RotationalDragCoefficient));
    }

    /// <summary>Gives a new body its drag.</summary>
    internal Body Applied(Body body)
    {
        body.LinearDragCoefficient = _linearDrag;
        body.RotationalDragCoefficient = _rotationalDrag;
        return body;
    }

    /// <summary>Gives a new geom its material.</summary>
    internal Geom Applied(Geom geom)
    {
        if (_friction != 0 || _restitution != 0)
        {
            geom.FrictionCoefficient = _friction;
            geom.RestitutionCoefficient = _restitution;
        }

        return geom;
    }

    /// <summary>Writes, or reads, what later calls of factories read of it.</summary>
    internal void Visit(StateStream s)
    {
        s.Value(ref _friction);
        s.Value(ref _restitution);
        s.Value(ref _linearDrag);
        s.Value(ref _rotationalDrag);
    }
}
