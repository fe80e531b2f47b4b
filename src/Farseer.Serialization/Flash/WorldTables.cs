using System.Numerics;
using Box2D.Collision.Shapes;
using Box2D.Common.Math;
using Box2D.Dynamics;
using FarseerGames.FarseerPhysics.Serialization.Tables;

namespace FarseerGames.FarseerPhysics.Serialization.Flash;

/// <summary>The members of worlds, bodies and shapes of the other facade.</summary>
internal static class WorldTables
{
    public static Table<b2World> World { get; } = new Table<b2World>()
        .Choice("quirks", w => w.Quirks, (w, v) => w.Quirks = v)
        .Flag("warmStarting", w => w.Engine.World.Settings.KeepImpulses, (w, v) => w.SetWarmStarting(v))
        .Flag("positionCorrection", w => w.Engine.World.Settings.CorrectPositions, (w, v) => w.SetPositionCorrection(v))
        .Flag("continuousPhysics", w => w.Engine.World.Settings.Continuous, (w, v) => w.SetContinuousPhysics(v));

    /// <summary>What a body has once its shapes and its mass are set; its sleep comes when the joints are made, which wake it.</summary>
    public static Table<b2Body> Body { get; } = new Table<b2Body>()
        .Number("linearDamping", b => b.GetLinearDamping(), (b, v) => b.SetLinearDamping(v))
        .Number("angularDamping", b => b.GetAngularDamping(), (b, v) => b.SetAngularDamping(v))
        .Flag("isBullet", b => b.IsBullet(), SetBullet)
        .Flag("allowSleep", b => b.Link.MaySleep, SetSleep);

    public static Table<b2Shape> Shape { get; } = new Table<b2Shape>()
        .Number("friction", s => s.GetFriction(), (s, v) => s.SetFriction(v))
        .Number("restitution", s => s.GetRestitution(), (s, v) => s.SetRestitution(v))
        .Number("density", s => s.GetDensity(), (s, v) => s.SetDensity(v))
        .Flag("isSensor", s => s.IsSensor(), (s, v) => s.SetSensor(v));

    public static b2Vec2 Of(Vector2 v) => new b2Vec2(v.X, v.Y);

    // What a body has anyway is not set: the ground comes to the engine only when something needs it.
    private static void SetBullet(b2Body body, bool value)
    {
        if (body.IsBullet() != value)
        {
            body.SetBullet(value);
        }
    }

    private static void SetSleep(b2Body body, bool value)
    {
        if (body.Link.MaySleep != value)
        {
            body.AllowSleeping(value);
        }
    }
}
