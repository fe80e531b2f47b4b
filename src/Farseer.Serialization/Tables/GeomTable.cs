using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Serialization.Tables;

/// <summary>The members of geoms but for their shapes.</summary>
internal static class GeomTable
{
    public static Table<Geom> All { get; } = new Table<Geom>()
        .Text("name", g => g.Name, (g, v) => g.Name = v)
        .Number("frictionCoefficient", g => g.FrictionCoefficient, (g, v) => g.FrictionCoefficient = v)
        .Number("restitutionCoefficient", g => g.RestitutionCoefficient, (g, v) => g.RestitutionCoefficient = v)
        .Number("surfaceSpeed", g => g.SurfaceSpeed, (g, v) => g.SurfaceSpeed = v)
        .Number("rollingResistance", g => g.RollingResistance, (g, v) => g.RollingResistance = v)
        .Vector("oneWayDirection", g => g.OneWayDirection, (g, v) => g.OneWayDirection = v)
        .Whole("collisionGroup", g => g.CollisionGroup, (g, v) => g.CollisionGroup = v)
        .Choice("collisionCategories", g => g.CollisionCategories, (g, v) => g.CollisionCategories = v)
        .Choice("collidesWith", g => g.CollidesWith, (g, v) => g.CollidesWith = v)
        .Flag("collisionEnabled", g => g.CollisionEnabled, (g, v) => g.CollisionEnabled = v)
        .Flag("collisionResponseEnabled", g => g.Link.ResponseEnabled, (g, v) => g.CollisionResponseEnabled = v)
        .Flag("isSensor", g => g.IsSensor, (g, v) => g.IsSensor = v)
        .Without(nameof(Geom.OnCollision), "a handler")
        .Without(nameof(Geom.OnSeparation), "a handler")
        .Without(nameof(Geom.AABB), "worked out from shape and place; what is set lasts until it moves")
        .Without(nameof(Geom.Matrix), "worked out from its body's place");
}
