using System.Collections.Generic;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Fine;

/// <summary>What the equations of motion need of a scene, whichever format it is written in.</summary>
internal abstract class FineScene
{
    public (double X, double Y) Gravity { get; protected init; }

    public List<FineBody> Bodies { get; } = [];

    public List<FineHinge> Hinges { get; } = [];

    public List<IFinePull> Pulls { get; } = [];

    /// <summary>What meets more slowly does not bounce.</summary>
    public abstract double BounceThreshold { get; }

    /// <summary>The scene as it starts.</summary>
    /// <exception cref="NotExpressedException">The scene has something that these equations do not know.</exception>
    public static FineScene Of(SceneFile file)
        => file.Format == SceneFormat.Box2DFlash ? new FlashFineScene(file) : new FarseerFineScene(file);

    /// <summary>Does what is due before a step.</summary>
    public abstract void Act(int step);

    /// <summary>The contact of two shapes, or null for a pair that does not collide.</summary>
    public abstract FineContact? Meet(FineShape a, FineShape b);
}
