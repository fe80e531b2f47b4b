using System;
using System.Numerics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Interfaces;
using FarseerGames.FarseerPhysics.Mathematics;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// The surface of water as a row of nodes whose heights run along as waves, with a generator of waves at its right end. It is a
/// container for a <see cref="FluidDragController"/>. y points down: the water is below <see cref="Position"/> and the surface.
/// </summary>
/// <example>
/// <code>
/// var sea = new WaveController { Position = new Vector2(-10, 0), Width = 20, Height = 4, NodeCount = 40 };
/// sea.Initialize();
/// simulator.Add(sea);
/// sea.Disturb(20, 0.5f);
/// </code>
/// </example>
public class WaveController : Controller, IFluidContainer, IStraightFluid
{
    private float[] _currentWave = Array.Empty<float>();
    private float[] _previousWave = Array.Empty<float>();
    private float[] _resultWave = Array.Empty<float>();
    private float[] _xPosition = Array.Empty<float>();
    private Vector2 _position;
    private float _width;
    private float _height;
    private int _nodeCount;
    private float _dampingCoefficient = 0.95f;
    private float _frequency = 0.18f;
    private float _waveGeneratorMin;
    private float _waveGeneratorMax;
    private float _waveGeneratorStep;
    private float _generator;
    private float _timePassed;
    private bool _falls;
    private float _highest;

    /// <summary>Makes a surface; set its properties and call <see cref="Initialize"/>.</summary>
    public WaveController()
    {
    }

    /// <summary>The point that <see cref="Contains"/> looked at last, in the world. Default (0, 0).</summary>
    public Vector2 VectorPoint { get; set; }

    /// <summary>The node left of the point that <see cref="Contains"/> looked at last, in the world. Default (0, 0).</summary>
    public Vector2 VectorNearWaveEdge { get; set; }

    /// <summary>The node right of the point that <see cref="Contains"/> looked at last, in the world. Default (0, 0).</summary>
    public Vector2 VectorFarWaveEdge { get; set; }

    /// <summary>Left end of the surface at rest; finite. Default (0, 0).</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public Vector2 Position
    {
        get => _position;
        set => _position = Require.Finite(value, nameof(Position));
    }

    /// <summary>Width of the water; finite and at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Width
    {
        get => _width;
        set => _width = Require.NotNegative(value, nameof(Width));
    }

    /// <summary>Depth of the water; finite and at least 0. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Height
    {
        get => _height;
        set => _height = Require.NotNegative(value, nameof(Height));
    }

    /// <summary>
    /// Number of nodes; 0, or at least 2 when <see cref="Initialize"/> is called, which lays them out: until then a surface keeps those
    /// that it has. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative.</exception>
    public int NodeCount
    {
        get => _nodeCount;
        set => _nodeCount = Require.AtLeast(value, 0, nameof(NodeCount));
    }

    /// <summary>Factor on the heights at each advance of the wave: 1 keeps the waves, 0 stops them; 0 to 1. Default 0.95.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is below 0 or above 1.</exception>
    public float DampingCoefficient
    {
        get => _dampingCoefficient;
        set => _dampingCoefficient = value >= 0 && value <= 1
            ? value
            : throw new ArgumentOutOfRangeException(nameof(DampingCoefficient), value, "value must be from 0 to 1.");
    }

    /// <summary>Seconds between two advances of the wave; finite and at least 0. Default 0.18.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is negative or not finite.</exception>
    public float Frequency
    {
        get => _frequency;
        set => _frequency = Require.NotNegative(value, nameof(Frequency));
    }

    /// <summary>
    /// The generator turns when it has gone below this height, in display units (see <see cref="ConvertUnits"/>); finite. Default 0.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float WaveGeneratorMin
    {
        get => _waveGeneratorMin;
        set => _waveGeneratorMin = Require.Finite(value, nameof(WaveGeneratorMin));
    }

    /// <summary>The generator turns when it has gone above this height, in display units; finite. Default 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float WaveGeneratorMax
    {
        get => _waveGeneratorMax;
        set => _waveGeneratorMax = Require.Finite(value, nameof(WaveGeneratorMax));
    }

    /// <summary>How far the generator goes at each advance, in display units; finite. Default 0: no waves are generated.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not finite.</exception>
    public float WaveGeneratorStep
    {
        get => _waveGeneratorStep;
        set => _waveGeneratorStep = Require.Finite(value, nameof(WaveGeneratorStep));
    }

    /// <summary>Heights of the nodes relative to <see cref="Position"/>, y down. Null until <see cref="Initialize"/>.</summary>
    public float[]? CurrentWave => _currentWave.Length > 0 ? _currentWave : null;

    /// <summary>Heights of the nodes one advance before. Null until <see cref="Initialize"/>.</summary>
    public float[]? PreviousWave => _previousWave.Length > 0 ? _previousWave : null;

    /// <summary>x of the nodes. Null until <see cref="Initialize"/>.</summary>
    /// <exception cref="ArgumentNullException">The value is null.</exception>
    /// <exception cref="ArgumentException">The value does not have a number for each node laid out, or to be laid out.</exception>
    public float[]? XPosition
    {
        get => _xPosition.Length > 0 ? _xPosition : null;
        set
        {
            Require.NotNull(value, nameof(XPosition));
            if (value!.Length != (_currentWave.Length > 0 ? _currentWave.Length : _nodeCount))
            {
                throw new ArgumentException("XPosition needs a number for each node.", nameof(XPosition));
            }

            _xPosition = value;
        }
    }

    /// <summary>Lays the nodes out along the width, at rest. Call it after setting the properties.</summary>
    /// <exception cref="InvalidOperationException"><see cref="NodeCount"/> is below 2.</exception>
    public void Initialize()
    {
        if (_nodeCount < 2)
        {
            throw new InvalidOperationException("NodeCount must be at least 2.");
        }

        _xPosition = new float[_nodeCount];
        _currentWave = new float[_nodeCount];
        _previousWave = new float[_nodeCount];
        _resultWave = new float[_nodeCount];
        for (int i = 0; i < _nodeCount; i++)
        {
            _xPosition[i] = _position.X + (_width * (i / (float)(_nodeCount - 1)));
        }

        _generator = 0;
        _timePassed = 0;
        _falls = false;
        _highest = 0;
    }

    /// <summary>Adds to the height of a node: a splash.</summary>
    /// <param name="node">Index of the node.</param>
    /// <param name="offset">The height to add, y down; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such node, or <paramref name="offset"/> is not finite.</exception>
    public void Disturb(int node, float offset)
    {
        Require.Finite(offset, nameof(offset));
        if (node < 0 || node >= _currentWave.Length)
        {
            throw new ArgumentOutOfRangeException(nameof(node), node, "node must be the index of a node.");
        }

        _currentWave[node] += offset;
        _highest = Math.Min(_highest, _currentWave[node]);
    }

    /// <inheritdoc />
    public bool Intersect(AABB aabb)
    {
        Require.NotNull(aabb, nameof(aabb));
        return _currentWave.Length > 0
            && aabb.Max.X >= _position.X && aabb.Min.X <= _position.X + _width
            && aabb.Max.Y >= _position.Y + _highest && aabb.Min.Y <= _position.Y + _height;
    }

    /// <inheritdoc />
    public bool Contains(ref Vector2 vector)
    {
        if (_currentWave.Length == 0
            || vector.X < _position.X || vector.X > _position.X + _width || vector.Y > _position.Y + _height)
        {
            return false;
        }

        int last = _currentWave.Length - 1;
        int left = Math.Min(Math.Max(0, (int)((vector.X - _position.X) / _width * last)), last - 1);
        var near = new Vector2(_xPosition[left], _position.Y + _currentWave[left]);
        var far = new Vector2(_xPosition[left + 1], _position.Y + _currentWave[left + 1]);
        VectorPoint = vector;
        VectorNearWaveEdge = near;
        VectorFarWaveEdge = far;
        Vector2 edge = far - near;
        Vector2 point = vector - near;
        return (edge.X * point.Y) - (edge.Y * point.X) >= 0;
    }

    void IStraightFluid.PartsWithin(double minX, double maxX, out int first, out int end)
    {
        int last = _currentWave.Length - 1;
        bool any = last > 0 && _width > 0 && maxX >= _position.X && minX <= (double)_position.X + _width;
        first = any ? NodeAt(minX, last) : 0;
        end = any ? NodeAt(maxX, last) + 1 : 0;
    }

    FluidPart IStraightFluid.Part(int index)
    {
        double stride = (double)_width / (_currentWave.Length - 1);
        double y = _position.Y;
        return new FluidPart(
            _position.X + (index * stride),
            _position.X + ((index + 1) * stride),
            y + _height,
            OutlineEdge.Line(_xPosition[index], y + _currentWave[index], _xPosition[index + 1], y + _currentWave[index + 1]));
    }

    /// <inheritdoc />
    public override void Validate()
    {
    }

    /// <inheritdoc />
    public override void Update(float dt)
    {
        Require.NotNegative(dt, nameof(dt));
        if (_currentWave.Length == 0)
        {
            return;
        }

        // The update after the one that completes the time advances the wave, as in the original.
        if (_timePassed < _frequency)
        {
            _timePassed += dt;
            return;
        }

        _timePassed = 0;
        Advance();
        Generate();
    }

    private int NodeAt(double x, int last) => (int)Math.Min(Math.Max(0, (x - _position.X) / _width * last), last - 1);

    private void Advance()
    {
        int last = _currentWave.Length - 1;
        _highest = 0;
        for (int i = 1; i < last; i++)
        {
            _resultWave[i] = (_currentWave[i - 1] + _currentWave[i + 1] - _previousWave[i]) * _dampingCoefficient;
            _highest = Math.Min(_highest, _resultWave[i]);
        }

        _resultWave[0] = 0;
        _resultWave[last] = 0;
        (_previousWave, _currentWave, _resultWave) = (_currentWave, _resultWave, _previousWave);
    }

    private void Generate()
    {
        bool isPast = _falls ? _generator < _waveGeneratorMin : _generator > _waveGeneratorMax;
        if (isPast)
        {
            _falls = !_falls;
        }
        else
        {
            _generator += _falls ? -_waveGeneratorStep : _waveGeneratorStep;
        }

        int last = _currentWave.Length - 1;
        _currentWave[last] = ConvertUnits.ToSimUnits(_generator);
        _highest = Math.Min(_highest, _currentWave[last]);
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        _currentWave = s.Reference(_currentWave)!;
        s.Array(_currentWave);
        _previousWave = s.Reference(_previousWave)!;
        s.Array(_previousWave);
        _resultWave = s.Reference(_resultWave)!;
        s.Array(_resultWave);
        _xPosition = s.Reference(_xPosition)!;
        s.Array(_xPosition);
        s.Value(ref _position);
        s.Value(ref _width);
        s.Value(ref _height);
        s.Value(ref _nodeCount);
        s.Value(ref _dampingCoefficient);
        s.Value(ref _frequency);
        s.Value(ref _waveGeneratorMin);
        s.Value(ref _waveGeneratorMax);
        s.Value(ref _waveGeneratorStep);
        s.Value(ref _generator);
        s.Value(ref _timePassed);
        s.Value(ref _falls);
        s.Value(ref _highest);
        VectorPoint = s.Value(VectorPoint);
        VectorNearWaveEdge = s.Value(VectorNearWaveEdge);
        VectorFarWaveEdge = s.Value(VectorFarWaveEdge);
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        fields.Values("currentWave", ref _currentWave);
        fields.Values("previousWave", ref _previousWave);
        fields.Values("resultWave", ref _resultWave);
        fields.Values("xPosition", ref _xPosition);
        fields.Value("generator", ref _generator);
        fields.Value("timePassed", ref _timePassed);
        fields.Value("falls", ref _falls);
        fields.Value("highest", ref _highest);
    }

    /// <summary>How many numbers there are of what has one for each node, besides the current wave.</summary>
    internal void CountNodes(out int previous, out int result, out int places)
    {
        previous = _previousWave.Length;
        result = _resultWave.Length;
        places = _xPosition.Length;
    }
}
