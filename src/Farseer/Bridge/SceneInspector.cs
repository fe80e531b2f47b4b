using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace FarseerGames.FarseerPhysics.Bridge;

/// <summary>Looks over a scene for likely mistakes. It changes nothing, and may take its time.</summary>
internal sealed class SceneInspector
{
    /// <summary>
    /// Share of the smaller one's shorter side from which on an overlap is deep, and of which a body is far below its rest depth.
    /// </summary>
    private const float DeepShare = 0.1f;

    /// <summary>Ratio of masses through joints or contacts from which on iterations count.</summary>
    private const float HeavyRatio = 100;

    private readonly PhysicsSimulator _simulator;
    private readonly List<InspectionFinding> _findings = new List<InspectionFinding>();
    private readonly List<Geom> _geoms;
    private readonly List<Body> _bodies = new List<Body>();
    private readonly List<Joint> _joints = new List<Joint>();

    public SceneInspector(PhysicsSimulator simulator)
    {
        _simulator = simulator;
        _geoms = new List<Geom>(simulator.ListPresent());
        simulator.ListPresent(_bodies);
        simulator.ListPresent(_joints);
    }

    public List<InspectionFinding> Run()
    {
        InspectMembership();
        InspectPairs();
        InspectFilters();
        InspectSpeeds();
        InspectJoints();
        _findings.Sort(static (a, b) => a.Number.CompareTo(b.Number));
        return _findings;
    }

    private void Find(int number, object subject, string message, string dial) =>
        _findings.Add(new InspectionFinding(number, subject, message, dial));

    private static string Show(double value) => value.ToString("G4", CultureInfo.InvariantCulture);

    private void InspectMembership()
    {
        var present = new HashSet<Body>(_bodies);
        foreach (Geom geom in _geoms)
        {
            if (!present.Contains(geom.Body) && !geom.Body.IsStatic)
            {
                Find(
                    1,
                    geom,
                    "Its body is not in the simulator, so nothing moves it.",
                    "Add the body, or set Body.IsStatic if it is meant to stand.");
            }
        }

        foreach (Body body in _bodies)
        {
            if (!body.IsStatic && !body.IsKinematic && !body.Geoms.Any(g => ReferenceEquals(g.Simulator, _simulator)))
            {
                Find(
                    2,
                    body,
                    "It has no geom in the simulator, so it meets nothing.",
                    "Make a geom for it, or leave it out of the simulator.");
            }

            if (!body.Enabled && body.IsQuarantined)
            {
                Find(
                    3,
                    body,
                    "It was taken out because its numbers were out of range.",
                    "See PhysicsSimulator.BodyQuarantined; set Body.Enabled to bring it back.");
            }
        }
    }

    private void InspectPairs()
    {
        var near = new List<Geom>();
        var all = new QueryFilter { IncludeSensors = true };
        foreach (Geom geom in _geoms)
        {
            if (geom.IsSensor || !geom.CollisionEnabled)
            {
                continue;
            }

            if (geom.RestitutionCoefficient > 1)
            {
                Find(
                    13,
                    geom,
                    "Its restitution, " + Show(geom.RestitutionCoefficient) + ", is above 1: bounces drive bodies on.",
                    "Set Geom.RestitutionCoefficient to 1 or less, unless it is a bumper.");
            }

            _simulator.QueryGeom(geom, near, all);
            foreach (Geom other in near)
            {
                if (geom < other && !other.IsSensor && Collide(geom, other) && (Moves(geom.Body) || Moves(other.Body)))
                {
                    InspectPair(geom, other);
                }
            }
        }
    }

    private void InspectPair(Geom geom, Geom other)
    {
        AABB a = geom.AABB;
        AABB b = other.AABB;
        float deep =
            Math.Min(Math.Min(a.Max.X, b.Max.X) - Math.Max(a.Min.X, b.Min.X), Math.Min(a.Max.Y, b.Max.Y) - Math.Max(a.Min.Y, b.Min.Y));
        float size = Math.Min(a.GetShortestSide(), b.GetShortestSide());
        float depth = Depth(geom, other);
        if (depth > DeepShare * size && deep > 0)
        {
            Find(
                4, geom, "It lies " + Show(depth) + " deep in " + other + ", whose smaller side is " + Show(size) + ".",
                "Place them apart, or let them: CollisionGroup. Falls of this kind are slowed by PhysicsSimulator.BiasFactor.");
        }

        if (geom.FrictionCoefficient + other.FrictionCoefficient == 0
            && Moves(geom.Body)
            && Moves(other.Body)
            && _simulator.Gravity != Vector2.Zero
            && _simulator.MixMaterials is null)
        {
            Find(
                5,
                geom,
                "It and " + other + " touch without friction: a stack slides apart.",
                "Set Geom.FrictionCoefficient; its default is 0.");
        }

        float heavy = Math.Max(geom.Body.Mass, other.Body.Mass);
        float light = Math.Min(geom.Body.Mass, other.Body.Mass);
        if (Moves(geom.Body) && Moves(other.Body) && heavy > HeavyRatio * light && !_simulator.AdaptIterations)
        {
            Find(
                6,
                geom,
                "It and " + other + " differ " + Show(heavy / light) + " times in mass.",
                "Set PhysicsSimulator.AdaptIterations, or Body.IterationFactor.");
        }
    }

    /// <summary>How deep the corners of one are in the other.</summary>
    private float Depth(Geom a, Geom b) => Math.Max(DeepestIn(a, b), DeepestIn(b, a));

    private float DeepestIn(Geom geom, Geom other)
    {
        float deepest = 0;
        var only = new QueryFilter { Accept = g => ReferenceEquals(g, other), IncludeSensors = true };
        foreach (Vector2 corner in geom.WorldVertices)
        {
            if (_simulator.ClosestPoint(corner, 0, out ClosestPointHit hit, only))
            {
                deepest = Math.Max(deepest, -hit.Distance);
            }
        }

        return deepest;
    }

    private static bool Moves(Body body) => body.Enabled && !body.IsStatic && !body.IsKinematic;

    private static bool Collide(Geom a, Geom b) => !ReferenceEquals(a.Body, b.Body) && a.CollisionEnabled && b.CollisionEnabled
        && (a.CollisionGroup == 0 || a.CollisionGroup != b.CollisionGroup)
        && (a.CollidesWith & b.CollisionCategories) != 0 && (b.CollidesWith & a.CollisionCategories) != 0;

    private void InspectFilters()
    {
        // Kinds of geoms by their filter and by whether they move: scenes have few.
        List<Geom> kinds = [.. _geoms.GroupBy(g =>
            (g.CollisionGroup, g.CollisionCategories, g.CollidesWith, g.CollisionEnabled, Moves(g.Body), g.Body)).Select(k => k.First())];
        foreach (Geom geom in kinds)
        {
            bool meets = false;
            bool wanted = false;
            foreach (Geom other in kinds)
            {
                if (!ReferenceEquals(geom.Body, other.Body)
                    && (Moves(geom.Body) || Moves(other.Body) || other.Body.IsKinematic || geom.Body.IsKinematic))
                {
                    meets |= Collide(geom, other);
                    wanted |= (geom.CollidesWith & other.CollisionCategories) != 0 && (other.CollidesWith & geom.CollisionCategories) == 0;
                }
            }

            if (!meets && geom.IsSensor)
            {
                Find(
                    7,
                    geom,
                    "Nothing in the scene can enter it.",
                    "Look at CollidesWith, CollisionCategories and CollisionGroup; static geoms do not meet each other.");
            }
            else if (!meets && wanted)
            {
                Find(
                    8,
                    geom,
                    "It wants to collide, but no other wants it.",
                    "Both sides must: CollidesWith of the others, or Farseer201Quirks.OneSidedCategoryFilter.");
            }
        }
    }

    private void InspectSpeeds()
    {
        if (_simulator.IsContinuousCollisionEnabled)
        {
            // Static walls are not passed then; bodies that move are.
            _bodies.FindAll(b => Moves(b) && !b.IsContinuousCollisionEnabled).ForEach(InspectSpeed);
        }
        else
        {
            _bodies.FindAll(Moves).ForEach(InspectSpeed);
        }
    }

    private void InspectSpeed(Body body)
    {
        const float Step = 1f / 60;
        float way = body.LinearVelocity.Length() * Step;
        Geom? thin =
            _geoms.Find(g => g.Body.IsStatic && !g.IsSensor && g.AABB.GetShortestSide() < way && body.Geoms.Any(own => Collide(own, g)));
        if (thin is not null)
        {
            Find(
                9, body, "It goes " + Show(way) + " in 1/60 s and may pass " + thin + ", which is " + Show(thin.AABB.GetShortestSide())
                    + " thick.",
                "Set IsContinuousCollisionEnabled of the simulator and the body.");
        }
    }

    private static (float Lower, float Upper) LimitsOf(Joint joint) => joint switch
    {
        DrivenPairJoint { AreLimitsEnabled: true } driven => (driven.LowerLimit, driven.UpperLimit),
        DrivenWorldJoint { AreLimitsEnabled: true } driven => (driven.LowerLimit, driven.UpperLimit),
        DistanceJoint { AreLimitsEnabled: true } distance => (distance.LowerLimit, distance.UpperLimit),
        AngleLimitJoint angle => (angle.LowerLimit, angle.UpperLimit),
        FixedAngleLimitJoint angle => (angle.LowerLimit, angle.UpperLimit),
        SliderJoint slider => (slider.Min, slider.Max),
        _ => (0, 0),
    };

    private void InspectJoints()
    {
        foreach (Joint joint in _joints)
        {
            if (joint is RopeJoint { MaxLength: 0 } or SliderJoint { Max: 0 } or DistanceJoint { TargetDistance: 0 })
            {
                Find(10, joint, "Its length is 0: it is a hinge that is solved less well.", "Use a RevoluteJoint, or give it a length.");
            }

            (float lower, float upper) = LimitsOf(joint);
            if (lower > upper)
            {
                Find(12, joint, "Its lower limit, " + Show(lower) + ", is above its upper one, " + Show(upper) + ".", "Exchange them.");
            }

            Body? one = joint.FirstBody;
            Body? two = joint.SecondBody;
            if (one is not null && two is not null && Moves(one) && Moves(two) && !_simulator.AdaptIterations)
            {
                float ratio = Math.Max(one.Mass, two.Mass) / Math.Min(one.Mass, two.Mass);
                if (ratio > HeavyRatio)
                {
                    Find(
                        6,
                        joint,
                        "Its bodies differ " + Show(ratio) + " times in mass.",
                        "Set PhysicsSimulator.AdaptIterations, or Body.IterationFactor.");
                }
            }

            if (one is { Enabled: true } && two is { Enabled: true } && !Moves(one) && !Moves(two))
            {
                Find(11, joint, "Neither of its bodies moves.", "Make one of them dynamic, or remove the joint.");
            }
        }
    }
}
