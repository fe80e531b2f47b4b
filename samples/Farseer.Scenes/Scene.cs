using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;

namespace Farseer.Scenes;

/// <summary>
/// A small world with a known outcome. An instance keeps the bodies of its last <see cref="Build"/>, so one instance
/// serves one simulator at a time; <see cref="SceneLibrary.All"/> makes fresh ones.
/// </summary>
public abstract class Scene
{
    /// <summary>Short name as typed on a command line: lower case, words joined by hyphens.</summary>
    public abstract string Name { get; }

    public abstract string Title { get; }

    /// <summary>One sentence: what is shown, and what must come out.</summary>
    public abstract string Description { get; }

    /// <summary>Updates after which <see cref="Check"/> is meant.</summary>
    public virtual int Steps => 600;

    /// <summary>Seconds an update.</summary>
    public virtual float Dt => 1f / 60f;

    /// <summary>The part of the world worth looking at.</summary>
    public abstract SceneView View { get; }

    /// <summary>Other worlds that run beside the main one; the scene itself steps them in <see cref="Act"/>.</summary>
    public virtual IReadOnlyList<SceneCompanion> Companions => Array.Empty<SceneCompanion>();

    /// <summary>Fills an empty simulator and sets gravity and the length constants. Calling it again starts over.</summary>
    public abstract void Build(PhysicsSimulator simulator);

    /// <summary>Called before each update; <paramref name="step"/> counts the updates done so far.</summary>
    public virtual void Act(PhysicsSimulator simulator, int step, float dt)
    {
    }

    /// <summary>What came out after <see cref="Steps"/> updates of <see cref="Dt"/> seconds.</summary>
    public abstract IReadOnlyList<SceneOutcome> Check();

    /// <summary>
    /// One update of the scene: what it does itself, then the simulator. A scene that updates in another way overrides it.
    /// </summary>
    public virtual void Step(PhysicsSimulator simulator, int step, float dt)
    {
        Act(simulator, step, dt);
        simulator.Update(dt);
    }

    /// <summary>Builds the scene in a new simulator and runs it to its end.</summary>
    public PhysicsSimulator RunToEnd()
    {
        PhysicsSimulator simulator = new PhysicsSimulator();
        Build(simulator);
        for (int step = 0; step < Steps; step++)
        {
            Step(simulator, step, Dt);
        }

        return simulator;
    }
}

/// <summary>A rectangle of the world.</summary>
public readonly record struct SceneView(Vector2 Min, Vector2 Max);

/// <summary>A second world of a scene and where to draw it: drawn point = (point + Shift) * Scale + Offset.</summary>
public readonly record struct SceneCompanion(PhysicsSimulator Simulator, double ShiftX, float Scale, Vector2 Offset);
