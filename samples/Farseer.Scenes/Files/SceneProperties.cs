using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;

namespace Farseer.Scenes;

/// <summary>The properties that a scene file may set, by the names of docs/SceneFormat.md. False: no such property.</summary>
internal static class SceneProperties
{
    public static bool Set(PhysicsSimulator simulator, string name, SceneNode value)
    {
        switch (name)
        {
            case "gravity": simulator.Gravity = value.Vector(); return true;
            case "iterations": simulator.Iterations = value.Whole(); return true;
            case "allowedPenetration": simulator.AllowedPenetration = value.Number(); return true;
            case "biasFactor": simulator.BiasFactor = value.Number(); return true;
            case "maxContactsToDetect": simulator.MaxContactsToDetect = value.Whole(); return true;
            case "maxContactsToResolve": simulator.MaxContactsToResolve = value.Whole(); return true;
            case "enabled": simulator.Enabled = value.Flag(); return true;
            case "frictionType": simulator.FrictionType = Friction(value); return true;
            case "broadPhaseCollider": simulator.BroadPhaseCollider = BroadPhase(simulator, value); return true;
            default: return false;
        }
    }

    public static bool Set(Body body, string name, SceneNode value)
    {
        switch (name)
        {
            case "position": body.Position = value.Vector(); return true;
            case "rotation": body.Rotation = value.Number(); return true;
            case "linearVelocity": body.LinearVelocity = value.Vector(); return true;
            case "angularVelocity": body.AngularVelocity = value.Number(); return true;
            case "mass": body.Mass = value.Number(); return true;
            case "momentOfInertia": body.MomentOfInertia = value.Number(); return true;
            case "isStatic": body.IsStatic = value.Flag(); return true;
            case "isKinematic": body.IsKinematic = value.Flag(); return true;
            case "enabled": body.Enabled = value.Flag(); return true;
            case "ignoreGravity": body.IgnoreGravity = value.Flag(); return true;
            case "isAutoIdle": body.IsAutoIdle = value.Flag(); return true;
            case "minimumVelocity": body.MinimumVelocity = value.Number(); return true;
            case "linearDragCoefficient": body.LinearDragCoefficient = value.Number(); return true;
            case "isQuadraticDragEnabled": body.IsQuadraticDragEnabled = value.Flag(); return true;
            case "quadraticDragCoefficient": body.QuadraticDragCoefficient = value.Number(); return true;
            case "rotationalDragCoefficient": body.RotationalDragCoefficient = value.Number(); return true;
            default: return false;
        }
    }

    public static bool Set(Geom geom, string name, SceneNode value)
    {
        switch (name)
        {
            case "restitutionCoefficient": geom.RestitutionCoefficient = value.Number(); return true;
            case "frictionCoefficient": geom.FrictionCoefficient = value.Number(); return true;
            case "collisionGroup": geom.CollisionGroup = value.Whole(); return true;
            case "collisionCategories": geom.CollisionCategories = Category(value); return true;
            case "collidesWith": geom.CollidesWith = Category(value); return true;
            case "collisionEnabled": geom.CollisionEnabled = value.Flag(); return true;
            case "collisionResponseEnabled": geom.CollisionResponseEnabled = value.Flag(); return true;
            case "isSensor": geom.IsSensor = value.Flag(); return true;
            case "onCollision":
                bool verdict = value.Flag();
                geom.OnCollision += (first, second, contacts) => verdict;
                return true;
            case "onSeparation":
                // A recorder in the reference runs; nothing to do without one.
                value.Flag();
                return true;
            default: return false;
        }
    }

    private static FrictionType Friction(SceneNode value) => value.Text() switch
    {
        "Average" => FrictionType.Average,
        "Minimum" => FrictionType.Minimum,
        _ => throw value.Fault("must be Average or Minimum"),
    };

    private static FarseerGames.FarseerPhysics.Interfaces.IBroadPhaseCollider BroadPhase(PhysicsSimulator simulator, SceneNode value) =>
        value.Text() switch
    {
        "SelectiveSweepCollider" => new SelectiveSweepCollider(simulator),
        "SweepAndPruneCollider" => new SweepAndPruneCollider(simulator),
        "BruteForceCollider" => new BruteForceCollider(simulator),
        _ => throw value.Fault("must be SelectiveSweepCollider, SweepAndPruneCollider or BruteForceCollider"),
    };

    /// <summary>A number of bits, or names such as "Cat1" or "Cat1, Cat4".</summary>
    private static CollisionCategory Category(SceneNode value)
    {
        if (!value.IsText)
        {
            return (CollisionCategory)value.Whole();
        }

        return System.Enum.TryParse(value.Text(), out CollisionCategory category)
            ? category
            : throw value.Fault("must be names out of None, All, Cat1 to Cat31");
    }
}
