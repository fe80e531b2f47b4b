using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Scenes;

/// <summary>A hollow drum of 24 staves turns at constant speed and tumbles 144 boxes.</summary>
public sealed class Tumbler : Scene
{
    private const int Staves = 24;
    private const float Radius = 5f;
    private const float Thickness = 0.6f;
    private const float Side = 0.4f;
    private const int Rows = 12;
    private const float Spin = 0.6f;
    private readonly List<Geom> _boxes = [];
    private Body? _drum;

    public override string Name => "tumbler";

    public override string Title => "Tumbler";

    public override string Description => "A turning hollow drum lifts 144 boxes on its rising side; none gets out.";

    public override SceneView View => new(new Vector2(-7f, -6f), new Vector2(7f, 6f));

    public override void Build(PhysicsSimulator simulator)
    {
        Make.Metres(simulator);
        _boxes.Clear();
        _drum = BodyFactory.Instance.CreateBody(simulator, 1f, 1f);
        float width = 2f * (Radius + Thickness) * (float)Math.Tan(Math.PI / Staves);
        for (int i = 0; i < Staves; i++)
        {
            double angle = 2.0 * Math.PI * i / Staves;
            Vector2 offset = (Radius + (0.5f * Thickness)) * new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle));
            Geom stave = GeomFactory.Instance.CreateRectangleGeom(simulator, _drum, Thickness, width, offset, (float)angle);
            stave.FrictionCoefficient = 0.6f;
        }

        _drum.IsKinematic = true;
        _drum.AngularVelocity = Spin;
        for (int row = 0; row < Rows; row++)
        {
            for (int column = 0; column < Rows; column++)
            {
                Vector2 position = 1.1f * Side * new Vector2(column - (0.5f * (Rows - 1)), row - (0.5f * (Rows - 1)));
                _boxes.Add(Make.Box(simulator, position, Side, Side, 0.6f));
            }
        }
    }

    public override IReadOnlyList<SceneOutcome> Check()
    {
        double farthest = 0.0;
        double centreX = 0.0;
        foreach (Geom box in _boxes)
        {
            Vector2 position = box.Body.Position;
            farthest = Math.Max(farthest, position.Length());
            centreX += position.X / _boxes.Count;
        }

        // Apothem of the drum plus half the diagonal of the polygon's corner; a box's centre stays half a side inside.
        double limit = (Radius / Math.Cos(Math.PI / Staves)) - (0.5 * Side) + 0.01;
        double fastest = Measure.FastestSpeed(_boxes);
        return
        [
            SceneOutcome.AtMost("farthest box from the axle (m)", farthest, limit),
            SceneOutcome.Error("turn of the drum (rad)", _drum!.TotalRotation, Spin * Steps * (double)Dt, 1e-3),
            SceneOutcome.AtMost("centre of the drum moved (m)", _drum.Position.Length(), 0.0),

            // Turning left, the drum's right-hand side rises and carries the heap with it; at rest the heap would lie at x = 0.
            SceneOutcome.AtLeast("heap carried to the rising side (m)", centreX, 0.5),

            // A box that falls freely through the whole drum reaches 14 m/s; more would be energy from nowhere.
            SceneOutcome.AtMost("fastest point (m/s)", fastest, Math.Sqrt(2.0 * Make.Gravity * 2.0 * Radius)),
        ];
    }
}
