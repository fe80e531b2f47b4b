using System;

namespace FarseerGames.FarseerPhysics;

/// <summary>
/// One of the worlds of a <see cref="WorldBatch"/>: a simulator, what an action does to it, and what is seen of it. Derive from it, and
/// keep references to the bodies and joints that the two need. (An addition to the original.)
/// </summary>
/// <remarks>
/// Worlds of a batch are stepped by several threads at a time, each by one: what they have in common they may read, not write. A simulator
/// here has best a
/// <see cref="PhysicsSimulator.WorkerCount"/> of 1: the batch keeps all processors busy already.
/// </remarks>
/// <example>
/// <code>
/// public sealed class PushedBox : BatchedWorld
/// {
///     private readonly Body _box;
///
///     public PushedBox()
///         : base(new PhysicsSimulator(new Vector2(0, 10)))
///     {
///         _box = BodyFactory.Instance.CreateRectangleBody(Simulator, 1, 1, 1);
///     }
///
///     public override void Act(ReadOnlySpan&lt;float&gt; action) =&gt; _box.ApplyForce(new Vector2(action[0], 0));
///
///     public override void Observe(Span&lt;float&gt; observation)
///     {
///         observation[0] = _box.Position.X;
///         observation[1] = _box.LinearVelocity.X;
///     }
/// }
/// </code>
/// </example>
public abstract class BatchedWorld
{
    /// <summary>Takes over a simulator, which belongs to no other world of the batch.</summary>
    /// <param name="simulator">The simulator.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    protected BatchedWorld(PhysicsSimulator simulator) => Simulator = Require.NotNull(simulator, nameof(simulator));

    /// <summary>The simulator that the batch updates.</summary>
    public PhysicsSimulator Simulator { get; }

    /// <summary>
    /// Lets an action take effect. Called before each update of a step, with the same action in all of them, so that forces act in all.
    /// </summary>
    /// <param name="action">The numbers of this world's action, <see cref="WorldBatch.ActionSize"/> of them.</param>
    public abstract void Act(ReadOnlySpan<float> action);

    /// <summary>Writes what is seen of the world. Called after the last update of a step.</summary>
    /// <param name="observation">Where to, <see cref="WorldBatch.ObservationSize"/> numbers; what is not written stays as it was.</param>
    public abstract void Observe(Span<float> observation);

    /// <summary>
    /// Called when the simulator has gone back to its first state, for what a derived class keeps besides. Does nothing by itself.
    /// </summary>
    protected internal virtual void OnReset()
    {
    }
}
