using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;
using System.Runtime.CompilerServices;
using Farseer.Hunt.Running;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Hunt.Farseer;

/// <summary>What is seen of worlds of Farseer Physics 2.0.</summary>
internal sealed partial class FarseerObserver : Observer
{
    private readonly HashSet<(int, int)> _touching = new();
    private readonly HashSet<Geom> _gone = new(ReferenceEqualityComparer.Instance);
    private readonly List<PhysicsSimulator> _worlds = new();

    public override void Made(object item, object?[] arguments)
    {
        switch (item)
        {
            case PhysicsSimulator simulator:
                _worlds.Add(simulator);
                simulator.BodyQuarantined += (_, e) =>
                {
                    if (IsMuted)
                    {
                        return;
                    }

                    string ties = simulator.JointList.Count + simulator.SpringList.Count > 0 ? " (A world with joints or springs.)" : "";
                    Quarantined.Add(string.Create(CultureInfo.InvariantCulture,
                        $"{e.Reason} Last call: {e.LastCall}, after step {e.LastCallStep} of {e.Step}.{ties}"));
                };
                simulator.GeomList.Removed += geom => _ = !IsMuted && _gone.Add(geom);
                simulator.GeomList.Added += geom => _gone.Remove(geom);
                break;
            case Geom geom:
                _numbers.AddOrUpdate(geom, _numbers.Count());
                geom.OnCollision += Begin;
                geom.OnSeparation += End;
                break;
        }
    }

    public override bool HasContacts(object world) => ((PhysicsSimulator)world).ArbiterList.Count > 0;

    /// <summary>The error of a step that lost a body.</summary>
    public override bool MayBeInfinite(object item, string member) =>
        item is PhysicsSimulator { Report.Cause: ErrorCause.Lost }
            && (member is "StepReport.ConstraintError" or "StepReport.Error" or "StepReport.ErrorShare" or "StepReport.BudgetLoad");

    public override void SetWorkers(object world, int count)
    {
        try
        {
            ((PhysicsSimulator)world).WorkerCount = count;
        }
        catch (ObjectDisposedException)
        {
        }
    }

    public override ulong Hash(object world)
    {
        try
        {
            return ((PhysicsSimulator)world).MotionHash();
        }
        catch (ObjectDisposedException)
        {
            return 0;
        }
    }

    public override List<BodyFact> Bodies(object world) => ((PhysicsSimulator)world).BodyList.Select(body =>
    {
        body.GetPosition(out double x, out double y);
        Vector2 velocity = body.LinearVelocity;
        return new BodyFact(x, y, velocity.X, velocity.Y, body.AngularVelocity, body.Mass, body.MomentOfInertia, !body.IsStatic
            && !body.IsKinematic && body.Enabled);
    }).ToList();

    public override (double X, double Y) Gravity(object world) => (((PhysicsSimulator)world).Gravity.X,
        ((PhysicsSimulator)world).Gravity.Y);

    public override IEnumerable<object> MoreItems(object world)
    {
        foreach (Arbiter arbiter in ((PhysicsSimulator)world).ArbiterList)
        {
            foreach (Contact contact in arbiter.ContactList)
            {
                yield return contact;
            }
        }
    }

    public override string? Lists(object world)
    {
        var simulator = (PhysicsSimulator)world;

        // An update that scaling passes over takes nothing out.
        bool isSwept = !simulator.Scaling.Enabled;
        HashSet<Geom> geoms = new(simulator.GeomList, ReferenceEqualityComparer.Instance);
        return simulator.BodyList.Count != simulator.BodyList.Distinct().Count() ? "a body is in the list twice"
            : simulator.GeomList.Count != geoms.Count ? "a geom is in the list twice"
            : simulator.JointList.Count != simulator.JointList.Distinct().Count() ? "a joint is in the list twice"
            : simulator.BodyList.Any(b => b.IsDisposed) && isSwept ? "a disposed body is in the list"
            : simulator.GeomList.Any(g => g.IsDisposed) && isSwept ? "a disposed geom is in the list"
            : simulator.JointList.Any(j => j.IsDisposed) && isSwept ? "a disposed joint is in the list"
            : simulator.SpringList.Any(s => s.IsDisposed) && isSwept ? "a disposed spring is in the list"
            : simulator.GeomList.Any(g => g.Body.IsDisposed) && isSwept ? "a geom of a disposed body is in the list"
            : simulator.ArbiterList.Any(a => !geoms.Contains(a.GeomA) || !geoms.Contains(a.GeomB))
                ? "a contact has a geom that is not in the list"
            : simulator.ArbiterList.Any(a => a.ContactList.Count == 0) ? "an arbiter has no contact"
            : null;
    }

    public override string? FallOfANewBody(object world)
    {
        var simulator = (PhysicsSimulator)world;
        simulator.Enabled = true;
        simulator.Scaling.Enabled = false;
        simulator.Gravity = new Vector2(0, -10);
        simulator.Update(1e-6f);
        foreach (Controller controller in simulator.ControllerList.ToList())
        {
            simulator.Remove(controller);
        }

        // Without a geom, since in extreme worlds there is something everywhere.
        Body late = BodyFactory.Instance.CreateCircleBody(simulator, 1, 1);
        late.Position = new Vector2(5000, 3000);
        for (int i = 0; i < 4; i++)
        {
            simulator.Update(0.01f);
        }

        float speed = -late.LinearVelocity.Y;
        return late.IsQuarantined || !(speed > 0.29f && speed < 0.41f) ? string.Create(CultureInfo.InvariantCulture,
            $"its speed is {speed} after 0.04 s") : null;
    }

    /// <summary>What is written through references is looked at when a step begins; a disabled body does not take part.</summary>
    public override bool IsStepped(object world, object item) => item is not Body body || (body.Enabled
        && world is PhysicsSimulator { Enabled: true } simulator && simulator.BodyList.Contains(body));

    private static (int One, int Other) Pair(Geom a, Geom b)
    {
        int one = RuntimeHelpers.GetHashCode(a);
        int other = RuntimeHelpers.GetHashCode(b);
        return one < other ? (one, other) : (other, one);
    }

    /// <summary>A restore brings back what was removed, and tells nobody.</summary>
    private bool IsGone(Geom geom) => _gone.Contains(geom) && !_worlds.Exists(w => w.GeomList.Contains(geom));

    private bool Begin(Geom a, Geom b, ContactList contacts)
    {
        if (IsMuted)
        {
            return true;
        }

        Tell(1, a, b);
        foreach (Contact contact in contacts)
        {
            Told((uint)BitConverter.SingleToInt32Bits(contact.Position.X));
            Told((uint)BitConverter.SingleToInt32Bits(contact.Position.Y));
            Told((uint)BitConverter.SingleToInt32Bits(contact.Separation));
        }

        if (IsGone(a) || IsGone(b))
        {
            Problems.Add(("OnCollision of a geom that was removed", ""));
        }

        if (contacts.Count == 0)
        {
            Problems.Add(("OnCollision without a contact", ""));
        }

        if (contacts.Any(c => !float.IsFinite(c.Position.X + c.Position.Y + c.Normal.X + c.Normal.Y + c.Separation)))
        {
            Problems.Add(("OnCollision with a contact that is not finite", string.Join(' ', contacts.Select(c
                => c.Position + " " + c.Normal + " " + c.Separation))));
        }

        _touching.Add(Pair(a, b));
        return true;
    }

    private void End(Geom a, Geom b)
    {
        if (IsMuted)
        {
            return;
        }

        Tell(2, a, b);
        // Both geoms tell of the end.
        if (!_touching.Contains(Pair(a, b)))
        {
            Problems.Add(("OnSeparation before OnCollision", ""));
        }
    }
}
