using System;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// What happened in the last update of a simulator, and while items were taken in and out since the one before: a view that is valid until
/// the next update, without allocation. Each list is empty unless its kind is in <see cref="PhysicsSimulator.RecordedEvents"/>. (An
/// addition to the original.)
/// </summary>
/// <remarks>
/// The order depends on the scene alone, not on workers, lanes or the asset: pairs of geoms go by the creation of the older one, then of
/// the other; broken joints and springs by when they broke; bodies by their index in <see cref="PhysicsSimulator.BodyList"/>.
/// </remarks>
/// <example>
/// <code>
/// simulator.RecordedEvents = StepEventKinds.Hits | StepEventKinds.Sensors;
/// simulator.Update(1f / 60);
/// foreach (HitEvent hit in simulator.Events.Hits)
/// {
///     sounds.Play("thud", hit.Point, volume: hit.ApproachSpeed / 10);
/// }
/// </code>
/// </example>
public sealed class StepEvents
{
    private readonly StepRecorder _recorder;

    internal StepEvents(StepRecorder recorder) => _recorder = recorder;

    /// <summary>Pairs that touch and did not before. A pair of which one is a sensor is in <see cref="SensorsEntered"/> instead.</summary>
    public ReadOnlySpan<ContactEvent> ContactsBegun => _recorder.Begun.Published;

    /// <summary>Pairs that no longer touch, also because one of them was removed or disposed.</summary>
    public ReadOnlySpan<ContactEvent> ContactsEnded => _recorder.Ended.Published;

    /// <summary>
    /// Pairs that came together faster than <see cref="PhysicsSimulator.HitSpeed"/> and pushed each other. A ball that bounces in each
    /// update is listed each time, also while its contact goes on.
    /// </summary>
    public ReadOnlySpan<HitEvent> Hits => _recorder.Hits.Published;

    /// <summary>
    /// Pairs that pushed each other, with what they gave each other in the whole update: over all pairs of a body this is its change of
    /// momentum, less that of gravity, forces, drag and joints.
    /// </summary>
    public ReadOnlySpan<PushEvent> Pushes => _recorder.Pushes.Published;

    /// <summary>Geoms that came into a sensor. Two sensors that meet are listed twice, each as the visitor of the other.</summary>
    public ReadOnlySpan<SensorEvent> SensorsEntered => _recorder.Entered.Published;

    /// <summary>Geoms that left a sensor, also because one of the two was removed or disposed.</summary>
    public ReadOnlySpan<SensorEvent> SensorsLeft => _recorder.Left.Published;

    /// <summary>Joints that broke.</summary>
    public ReadOnlySpan<Joint> BrokenJoints => _recorder.Joints.Published;

    /// <summary>Springs that broke.</summary>
    public ReadOnlySpan<Spring> BrokenSprings => _recorder.Springs.Published;

    /// <summary>Bodies that fell asleep.</summary>
    public ReadOnlySpan<Body> FellAsleep => _recorder.Asleep.Published;

    /// <summary>Bodies that woke.</summary>
    public ReadOnlySpan<Body> Woke => _recorder.Awake.Published;

    /// <summary>Bodies whose position or rotation has changed since the update before, by themselves or by your program.</summary>
    public ReadOnlySpan<Body> Moved => _recorder.Moved.Published;
}
