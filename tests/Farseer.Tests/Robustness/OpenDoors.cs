using System;
using System.Collections.Generic;
using System.Linq;

namespace Farseer.Tests.Robustness;

/// <summary>Doors through which any value may come, and why. A key ends with * where it stands for all that begin so.</summary>
internal static class OpenDoors
{
    private const string Arithmetic = "pure arithmetic as in System.Math: what is not finite gives what is not finite, and nothing is kept";
    private const string Question = "a question: no place that is not finite is near or in anything, and nothing is kept";
    private const string NoHandler = "null takes all handlers away";
    private const string NoFilter = "null leaves nothing out";
    private const string Comparison = "nothing equals null or a thing of another kind";
    private const string Report = "a record of what was found, for the user to fill; the simulation does not read it";
    private const string Bits = "any set of bits is a set of categories or a number of a group";
    private const string List = "a list of points accepts any; what is made of it checks them";

    private static readonly Dictionary<string, string> _reasons = new Dictionary<string, string>
    {
        ["Calculator.*"] = Arithmetic,
        ["ComplexFactory.CreateChain(collisionGroup)"] = Bits,
        ["ComplexFactory.CreateRope(collisionGroup)"] = Bits,
        ["ComplexFactory.CreateTrack(collisionGroup)"] = Bits,
        ["Path.CreateGeoms(collisionGroup)"] = Bits,
        ["Path.FindMidpoint*"] = Arithmetic,
        ["Path.PointInControlPoint*"] = Question,
        ["Path.Remove(controlPoint)"] = Question,
        ["MathHelper.*"] = Arithmetic,
        ["ConvertUnits.To*"] = Arithmetic,
        ["MatrixPorting.*"] = Arithmetic,
        ["Vector2Porting.*"] = Arithmetic,
        ["Vector3Porting.*"] = Arithmetic,
        ["BilinearInterpolator.*"] = Arithmetic,
        ["CircularInterpolator.*"] = Arithmetic,
        ["CollisionHelper.*"] = Question,
        ["AABB.Contains*"] = Question,
        ["Body.GetWorldPosition*"] = Arithmetic,
        ["Body.GetLocalPosition*"] = Arithmetic,
        ["Body.GetVelocity*"] = Arithmetic,
        ["Body.Tag"] = "the user's own",
        ["Body.Name"] = "the user's own",
        ["Geom.Name"] = "the user's own",
        ["Body.Updated"] = NoHandler,
        ["BodyList.Added"] = NoHandler,
        ["JointList.Added"] = NoHandler,
        ["JointList.Removed"] = NoHandler,
        ["BodyList.Removed"] = NoHandler,
        ["GeomList.Added"] = NoHandler,
        ["GeomList.Removed"] = NoHandler,
        ["Geom.OnCollision"] = NoHandler,
        ["Geom.OnSeparation"] = NoHandler,
        ["PhysicsSimulatorState.IsSameAs(other)"] = Comparison,
        ["PhysicsSimulator.StepScheduler"] = "null stands for threads of the simulator's own",
        ["Geom.Tag"] = "the user's own",
        ["Joint.Tag"] = "the user's own",
        ["Geom.Collide(point)"] = Question,
        ["Geom.GetNearestDistance*"] = Question,
        ["Geom.GetNearestFeature(point)"] = Question,
        ["Geom.GetWorldPosition*"] = Arithmetic,
        ["Geom.Transform*"] = Arithmetic,
        ["Geom.Intersect*"] = Question,
        ["Geom.CollisionGroup"] = Bits,
        ["Geom.CollisionCategories"] = Bits,
        ["Geom.CollisionCategory"] = Bits,
        ["Geom.CollidesWith"] = Bits,
        ["Geom.op_Equality*"] = Comparison,
        ["Geom.op_Inequality*"] = Comparison,
        ["Geom.Equals*"] = Comparison,
        ["Arbiter.op_Equality*"] = Comparison,
        ["Arbiter.op_Inequality*"] = Comparison,
        ["Arbiter.Equals*"] = Comparison,
        ["Arbiter.Geom*"] = "an arbiter without geoms names no pair; a broad phase may leave it so",
        ["Contact.*"] = Report,
        ["ContactId.*"] = Report,
        ["ContactList.IndexOfSafe*"] = Question,
        ["Feature.*"] = Report,
        ["LineIntersectInfo.*"] = Report,
        ["Grid.Intersect*"] = Question,
        ["PhysicsSimulator.Collide*"] = Question,
        ["PhysicsSimulator.RayCast(filter)"] = NoFilter,
        ["PhysicsSimulator.RayCastAll(filter)"] = NoFilter,
        ["PhysicsSimulator.Query(filter)"] = NoFilter,
        ["PhysicsSimulator.QueryPoint(filter)"] = NoFilter,
        ["PhysicsSimulator.QueryCircle(filter)"] = NoFilter,
        ["PhysicsSimulator.QueryGeom(filter)"] = NoFilter,
        ["PhysicsSimulator.CircleCast(filter)"] = NoFilter,
        ["PhysicsSimulator.ShapeCast(filter)"] = NoFilter,
        ["PhysicsSimulator.ClosestPoint(filter)"] = NoFilter,
        ["QueryFilter.Categories"] = Bits,
        ["QueryFilter.IgnoredBody"] = NoFilter,
        ["QueryFilter.Accept"] = NoFilter,
        ["RayCastHit.Equals*"] = Comparison,
        ["Pose.Equals*"] = Comparison,
        ["SurfaceMaterial.Equals*"] = Comparison,
        ["PhysicsSimulator.MixMaterials"] = "null leaves all to the rules",
        ["ItemList.get_Item*"] = "an indexer names its index or its value",
        ["ItemList.Item"] = "an indexer names its index or its value",
        ["BodyGeoms.Equals*"] = Comparison,
        ["FixedStepDriver.BeforeStep"] = NoHandler,
        ["FixedStepDriver.AfterStep"] = NoHandler,
        ["ClosestPointHit.Equals*"] = Comparison,
        ["Vertices.ProjectToAxis(axis)"] = Arithmetic,
        ["Vertices.new(vertices)"] = List,
        ["Vertices.new(vector2)"] = List,
        ["CollisionPair.Equals*"] = Comparison,
        ["Spring.Tag"] = "the user's own",
        ["Controller.Tag"] = "the user's own",
        ["SpringList.Added"] = NoHandler,
        ["SpringList.Removed"] = NoHandler,
        ["ControllerList.Added"] = NoHandler,
        ["ControllerList.Removed"] = NoHandler,
        ["FluidDragController.Entry"] = NoHandler,
        ["AccuracyAdvisor.Advise(progress)"] = "null tells nobody",
        ["BodyController.Filter"] = "null lets all bodies pass",
        ["SvgDebugDraw.Draw*"] = "a place that is not finite is nowhere in the picture; a debug view must not stop the game",
        ["DebugColor.Equals*"] = Comparison,
        ["CurveKey.op_*"] = Comparison,
        ["CurveKey.Equals*"] = Comparison,
        ["CurveKey.CompareTo*"] = Comparison,
        ["CurveKeyCollection.Item"] = "an indexer names its index or its value",
        ["CurveKeyCollection.Contains*"] = Question,
        ["CurveKeyCollection.IndexOf*"] = Question,
        ["CurveKeyCollection.Remove(item)"] = Question,
        ["WindController.Area"] = "null is everywhere",
        ["AABBFluidContainer.Contains*"] = Question,
        ["WaveController.Contains*"] = Question,
        ["WaveController.Vector*"] = Report,
    };

    public static IReadOnlyDictionary<string, string> Reasons => _reasons;

    public static bool Fits(string pattern, string key) =>
        pattern.EndsWith('*') ? key.StartsWith(pattern[..^1], StringComparison.Ordinal) : key == pattern;

    public static bool Contains(Door door) => _reasons.Keys.Any(pattern => Fits(pattern, door.Key));
}
