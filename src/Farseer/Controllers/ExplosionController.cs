using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// Throws bodies away from points: each call of <see cref="Explode"/> acts once, at the next update. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// var blast = new ExplosionController();
/// simulator.Add(blast);
/// blast.Explode(center: new Vector2(0, 0), radius: 5, impulse: 20);
/// </code>
/// </example>
public class ExplosionController : BodyController
{
    private readonly List<Charge> _charges = new List<Charge>();

    /// <summary>Makes a controller without charges.</summary>
    public ExplosionController()
    {
    }

    /// <summary>Sets off a charge at the next update.</summary>
    /// <param name="center">The centre, in the world; finite.</param>
    /// <param name="radius">Distance at which the blast has fallen to 0; finite and above 0.</param>
    /// <param name="impulse">
    /// Impulse on a body at the centre, mass times velocity; it falls evenly to 0 at the radius. Finite; a negative one pulls.
    /// </param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range.</exception>
    public void Explode(Vector2 center, float radius, float impulse)
    {
        _charges.Add(new Charge(
            Require.Finite(center, nameof(center)), Require.Positive(radius, nameof(radius)), Require.Finite(impulse, nameof(impulse))));
    }

    /// <inheritdoc />
    public override void Update(float dt)
    {
        Require.NotNegative(dt, nameof(dt));
        if (_charges.Count > 0)
        {
            base.Update(dt);
            _charges.Clear();
        }
    }

    /// <inheritdoc />
    protected override void Act(Body body, float dt)
    {
        Require.NotNull(body, nameof(body));
        for (int i = 0; i < _charges.Count; i++)
        {
            Charge charge = _charges[i];
            Vector2 away = body.Position - charge.Center;
            float distance = away.Length();
            if (distance > 0 && distance < charge.Radius)
            {
                body.LinearVelocity += charge.Impulse * (1 - (distance / charge.Radius)) * body.InverseMass / distance * away;
            }
        }
    }

    private readonly struct Charge
    {
        public Charge(Vector2 center, float radius, float impulse)
        {
            Center = center;
            Radius = radius;
            Impulse = impulse;
        }

        public Vector2 Center { get; }

        public float Radius { get; }

        public float Impulse { get; }
    }

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        s.List(_charges);
    }

    /// <inheritdoc/>
    internal override void VisitHidden(IHiddenFields fields)
    {
        base.VisitHidden(fields);
        float[] charges = [.. _charges.SelectMany(c => new[] { c.Center.X, c.Center.Y, c.Radius, c.Impulse })];
        fields.Values("charges", ref charges);
        _charges.Clear();
        for (int i = 0; i + 3 < charges.Length; i += 4)
        {
            Explode(new Vector2(charges[i], charges[i + 1]), charges[i + 2], charges[i + 3]);
        }
    }
}
