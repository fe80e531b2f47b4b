using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes;

/// <summary>A row of dominoes; the first is tipped, the others fall one after the other.</summary>
public sealed class Dominoes : Scene
{
    private const int Count = 20;
    private const float Width = 0.2f;
    private const float Height = 1f;
    private const float Spacing = 0.5f;

    /// <summary>Spin of the first domino about its lower right corner; 0.76 rad/s just tips it over.</summary>
    private const float Push = -1.5f;

    /// <summary>Lean at which a domino counts as falling: twice the 11.3 degrees at which it tips by itself.</summary>
    private const double FallingAngle = 0.39;

    private readonly List<Geom> _dominoes = [];
    private readonly int[] _fellAt = new int[Count];

    public override string Name => "dominoes";

    public override string Title => "Dominoes";

    public override string Description => "The first of 20 dominoes is tipped; all fall, one after the other.";

    public override SceneView View => new(new Vector2(-6.5f, -1f), new Vector2(6.5f, 3f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        Make.Floor(simulator, 30f);
        _dominoes.Clear();
        Array.Fill(_fellAt, -1);
        for (int i = 0; i < Count; i++)
        {
            float x = Spacing * (i - (0.5f * (Count - 1)));
            _dominoes.Add(Make.Box(simulator, new Vector2(x, 0.5f * Height), Width, Height));
        }

        Body first = _dominoes[0].Body;
        first.AngularVelocity = Push;
        first.LinearVelocity = new Vector2(-Push * 0.5f * Height, -Push * 0.5f * Width);
    }

    public override void Act(PhysicsSimulator simulator, int step, float dt)
    {
        for (int i = 0; i < Count; i++)
        {
            if (_fellAt[i] < 0 && Math.Abs(Measure.Angle(_dominoes[i].Body)) > FallingAngle)
            {
                _fellAt[i] = step;
            }
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        int fallen = 0;
        int inOrder = 0;
        for (int i = 0; i < Count; i++)
        {
            double lean = -Measure.Angle(_dominoes[i].Body);
            fallen += lean > 0.25 * Math.PI ? 1 : 0;
            inOrder += _fellAt[i] >= 0 && (i == 0 || _fellAt[i] > _fellAt[i - 1]) ? 1 : 0;
        }

        Body last = _dominoes[^1].Body;
        return
        [
            SceneOutcome.Exactly("dominoes fallen forwards", fallen, Count),
            SceneOutcome.Exactly("dominoes that fell after their neighbour", inOrder, Count),

            // Nothing lies under the last one but the floor; the domino before it leans on it and presses it a little deeper.
            SceneOutcome.Error("height of the last, lying (m)", last.Position.Y, 0.5 * Width, Make.Tolerance),
            SceneOutcome.Error("tilt of the last from lying (rad)", -Measure.Angle(last), 0.5 * Math.PI, 0.01),
            SceneOutcome.AtMost("fastest point at the end (m/s)", Measure.FastestSpeed(_dominoes), 0.01),
        ];
    }
}
