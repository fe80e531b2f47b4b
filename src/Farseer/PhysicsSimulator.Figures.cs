using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;

namespace FarseerGames.FarseerPhysics;

/// <content>Figures of the state as a whole, for tests, benchmarks and displays. (Additions to the original.)</content>
public partial class PhysicsSimulator
{
    // What a hash is made of: filled each time.
    [NotState(Why.OfOneStep)]
    private StateStream? _hashed;

    /// <summary>
    /// Pairs of pieces that touch after the last update; a geom of a concave outline or a chain has several pieces. Counted when asked for.
    /// </summary>
    public int ContactCount => World.Reader.Count;

    /// <summary>
    /// Deepest overlap of two geoms that push each other apart, a length of the scene, after the last update; 0 if there is none. Measured
    /// when asked for.
    /// </summary>
    public float LargestPenetration => World.Reader.LargestPenetration();

    /// <summary>
    /// A 64-bit hash of the positions and velocities of all bodies. The same scene gives the same hash on every platform and processor; if
    /// two hashes differ, so do the states. It is quick and may be asked for at any time. <see cref="StateHash"/> covers everything else
    /// that later updates depend on.
    /// </summary>
    /// <returns>The hash.</returns>
    public ulong MotionHash() => World.Bodies.MotionHash();

    /// <summary>
    /// A 64-bit hash of all that <see cref="Capture(PhysicsSimulatorState)"/> captures: two simulators that were made by the same program
    /// and have the same hash go on alike. It is the same on every processor and with every number of workers, and takes as
    /// long as two or three captures.
    /// </summary>
    /// <remarks>
    /// References count by whom they refer to, counted as they were added; of handlers it counts only whether there is one. Items of your
    /// own count with what they save (<see cref="Interfaces.ISavedState"/>). <see cref="Compare"/> tells where two states differ.
    /// </remarks>
    /// <returns>The hash.</returns>
    /// <exception cref="System.ObjectDisposedException">The simulator is disposed.</exception>
    /// <exception cref="System.InvalidOperationException">An update runs.</exception>
    public ulong StateHash()
    {
        ThrowIfDisposed();
        RequireOutside(nameof(StateHash));
        StateStream s = _hashed ??= new StateStream();
        StateRoster present = Present;
        Gather(present);
        present.IsInUse = true;
        try
        {
            s.BeginWriting();
            present.Visit(s);
            Visit(s, present);
            s.EndWriting(present.Round);
            ulong hash = StateHasher.Add(StateHasher.Start, s);
            for (int i = 0; i < s.ObjectCount; i++)
            {
                hash = StateHasher.Add(hash, present.Number(s.Objects[i]));
            }

            return hash;
        }
        finally
        {
            present.IsInUse = false;
            present.Clear();
            s.ForgetObjects();
        }
    }

    /// <summary>Compares the state with that of another simulator that was made by the same program.</summary>
    /// <param name="other">The other one.</param>
    /// <param name="most">The search ends when it has found so many differences; at least 1. Default 100.</param>
    /// <returns>The differences, by body, geom, joint or pair and by field, with both values and their bits.</returns>
    /// <exception cref="System.ArgumentNullException"><paramref name="other"/> is null.</exception>
    /// <exception cref="System.ArgumentOutOfRangeException"><paramref name="most"/> is less than 1.</exception>
    /// <exception cref="System.ObjectDisposedException">One of them is disposed.</exception>
    /// <exception cref="System.InvalidOperationException">
    /// An update runs, or an item of your own does not implement <see cref="Interfaces.ISavedState"/>.
    /// </exception>
    public StateComparison Compare(PhysicsSimulator other, int most = 100)
    {
        Require.NotNull(other, nameof(other));
        Require.AtLeast(most, 1, nameof(most));
        return StateNames.Compare(this, StateNames.Named(this), StateNames.Named(other), false, most);
    }

    /// <summary>Tells those who watch the process what the step was like.</summary>
    private void TellStep()
    {
        StepFigures figures;
        figures.Step = StepCount;
        figures.Bodies = BodyList.Count;
        figures.Sleeping = World.Sleep.AsleepCount;
        figures.Contacts = World.Reader.Count;
        figures.Islands = World.IslandCount;
        figures.Substeps = World.Substeps;
        figures.MissedBudget = _errorBudget.IsBounded && World.Accuracy.HasMeasured && !Report.IsWithinBudget;
        StepSignals.TellStep(World, figures);
    }
}
