using System;
using Farseer.Engine.Storage;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Dynamics;

namespace FarseerGames.FarseerPhysics.Controllers;

/// <summary>
/// Base of the controllers that act on bodies one by one: on all of the simulator, or on those that <see cref="Filter"/> lets pass.
/// Disabled and static bodies are left out. (An addition to the original.)
/// </summary>
/// <example>
/// <code>
/// var wind = new WindController(new Vector2(3, 0), 0.5f) { Filter = b =&gt; b.Mass &lt; 10 };
/// simulator.Add(wind);
/// </code>
/// </example>
public abstract class BodyController : Controller
{
    /// <summary>Makes a controller for all bodies.</summary>
    protected BodyController()
    {
    }

    /// <summary>Chooses the bodies: true lets the controller act. Default null: it acts on all.</summary>
    public Func<Body, bool>? Filter { get; set; }

    /// <inheritdoc />
    public override void Validate()
    {
    }

    /// <inheritdoc />
    public override void Update(float dt)
    {
        Require.NotNegative(dt, nameof(dt));
        if (Simulator is not { } simulator)
        {
            return;
        }

        BodyList bodies = simulator.BodyList;
        for (int i = 0; i < bodies.Count; i++)
        {
            Body body = bodies[i];
            try
            {
                if (body.Enabled && !body.IsDisposed && body.InverseMass > 0 && (Filter is null || Filter(body)))
                {
                    Act(body, dt);
                }
            }
            catch (Exception exception) when (simulator.IsUpdating)
            {
                // One body does not keep the others from their share.
                simulator.Relay.Keep(exception);
            }
        }
    }

    /// <summary>Acts on a body, at the moment at which forces act.</summary>
    /// <param name="body">An enabled body that can move.</param>
    /// <param name="dt">The step, seconds.</param>
    protected abstract void Act(Body body, float dt);

    /// <inheritdoc/>
    internal override void Visit(StateStream s)
    {
        base.Visit(s);
        Filter = s.Reference(Filter);
    }
}
