using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;


namespace FarseerGames.FarseerPhysics;

/// <summary>
/// Lets the simulator update less often under load. While enabled, the time given to <see cref="PhysicsSimulator.Update(float)"/>
/// is gathered until <see cref="UpdateInterval"/> has passed and then simulated in one step. The interval follows the real time between
/// updates: it grows by a quarter of the preferred interval at each update that took longer than it, up to
/// <see cref="MaximumUpdateInterval"/>, and shrinks by an eighth at each that took less, down to the preferred interval.
/// </summary>
/// <example>
/// <code>
/// simulator.Scaling = new Scaling(preferredUpdateInterval: 1f / 120, maximumUpdateInterval: 1f / 30) { Enabled = true };
/// </code>
/// </example>
public class Scaling
{
    private readonly float _preferredUpdateInterval;
    private float _maximumUpdateInterval;
    private float _updateInterval;
    private float _gathered;

    /// <summary>Makes a scaling that is not yet enabled.</summary>
    /// <param name="preferredUpdateInterval">Interval without load, seconds; above 0.</param>
    /// <param name="maximumUpdateInterval">Largest interval under load, seconds; at least the preferred one.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">An interval is not finite or not above 0.</exception>
    public Scaling(float preferredUpdateInterval, float maximumUpdateInterval)
    {
        _preferredUpdateInterval = Require.Positive(preferredUpdateInterval, nameof(preferredUpdateInterval));
        _maximumUpdateInterval = Require.Positive(maximumUpdateInterval, nameof(maximumUpdateInterval));
        _updateInterval = preferredUpdateInterval;
    }

    internal float PreferredUpdateInterval => _preferredUpdateInterval;

    /// <summary>Default false.</summary>
    public bool Enabled { get; set; }

    /// <summary>Largest interval under load, seconds. Default of a simulator: 0.01.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The value is not finite or not above 0.</exception>
    public float MaximumUpdateInterval
    {
        get => _maximumUpdateInterval;
        set => _maximumUpdateInterval = Require.Positive(value, nameof(MaximumUpdateInterval));
    }

    /// <summary>Interval in force, seconds. Default of a simulator: 0.001.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The value is not finite or not above 0.</exception>
    public float UpdateInterval
    {
        get => _updateInterval;
        set => _updateInterval = Require.Positive(value, nameof(UpdateInterval));
    }

    /// <summary>Shrinks the interval by an eighth of the preferred one, not below that.</summary>
    public void DecreaseUpdateInterval()
    {
        float next = _updateInterval - (0.125f * _preferredUpdateInterval);
        _updateInterval = next > _preferredUpdateInterval ? next : _preferredUpdateInterval;
    }

    /// <summary>Grows the interval by a quarter of the preferred one, up to the maximum.</summary>
    public void IncreaseUpdateInterval()
    {
        float next = _updateInterval + (0.25f * _preferredUpdateInterval);
        _updateInterval = next < _maximumUpdateInterval ? next : _maximumUpdateInterval;
    }

    /// <summary>Gathers time and tells how much of it to simulate now.</summary>
    /// <param name="dt">Time that passed, seconds; finite and at least 0.</param>
    /// <returns><paramref name="dt"/> itself while not enabled; otherwise 0, or the gathered time once the interval is full.</returns>
    /// <exception cref="System.ArgumentOutOfRangeException"><paramref name="dt"/> is negative or not finite.</exception>
    public float GetUpdateInterval(float dt)
    {
        Require.NotNegative(dt, nameof(dt));
        if (!Enabled)
        {
            return dt;
        }

        _gathered += dt;
        if (_gathered < _updateInterval)
        {
            return 0;
        }

        float step = _gathered;
        _gathered = 0;
        return step;
    }

    /// <summary>Writes, or reads, what later updates read of it.</summary>
    internal void Visit(StateStream s)
    {
        s.Value(ref _maximumUpdateInterval);
        s.Value(ref _updateInterval);
        s.Value(ref _gathered);
        Enabled = s.Value(Enabled);
    }

    /// <summary>Lets what no public property shows be saved or set.</summary>
    internal void VisitHidden(IHiddenFields fields)
    {
        fields.Value("gathered", ref _gathered);
    }
}
