using System.Numerics;
using Box2D.Common.Math;
using Box2D.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Serialization.Documents;

namespace FarseerGames.FarseerPhysics.Serialization.Flash;

/// <summary>The kinds of joints of the other facade.</summary>
internal static class WorldJoints
{
    public static string NameOf(b2Joint joint) => joint switch
    {
        b2DistanceJoint => "Distance",
        b2GearJoint => "Gear",
        b2MouseJoint => "Mouse",
        b2PrismaticJoint => "Prismatic",
        b2PulleyJoint => "Pulley",
        _ => "Revolute",
    };

    /// <summary>Where it holds its bodies, in their own coordinates; null: it has no such place.</summary>
    public static (b2Vec2? First, b2Vec2? Second) LocalsOf(b2Joint joint) => joint switch
    {
        b2DistanceJoint distance => (distance.Local1, distance.Local2),
        b2DrivenJoint driven => (driven.Local1, driven.Local2),
        b2PulleyJoint pulley => (pulley.Local1, pulley.Local2),
        b2MouseJoint mouse => (null, mouse.Local),
        _ => (null, null),
    };

    /// <summary>A definition of the kind with which one can be made; its numbers are set afterwards.</summary>
    public static b2JointDef Define(SceneObject members, WorldContents contents, out Vector2 local2)
    {
        SceneNode kind = members.Take("kind");
        Vector2 local1 = Vector(members, "localAnchor1");
        local2 = Vector(members, "localAnchor2");
        switch (kind.Text())
        {
            case "Distance":
                return new b2DistanceJointDef { localAnchor1 = WorldTables.Of(local1), localAnchor2 = WorldTables.Of(local2) };
            case "Gear":
                return new b2GearJointDef { joint1 = JointOf(members, "joint1", contents), joint2 = JointOf(members, "joint2", contents) };
            case "Mouse":
                return new b2MouseJointDef();
            case "Prismatic":
                return new b2PrismaticJointDef { localAnchor1 = WorldTables.Of(local1), localAnchor2 = WorldTables.Of(local2) };
            case "Pulley":
                return new b2PulleyJointDef
                {
                    localAnchor1 = WorldTables.Of(local1), localAnchor2 = WorldTables.Of(local2),
                    groundAnchor1 = Ground(members, "ground1X", "ground1Y"), groundAnchor2 = Ground(members, "ground2X", "ground2Y"),
                };
            case "Revolute":
                return new b2RevoluteJointDef { localAnchor1 = WorldTables.Of(local1), localAnchor2 = WorldTables.Of(local2) };
            default:
                throw kind.Error("is no kind of joint");
        }
    }

    private static Vector2 Vector(SceneObject members, string name) =>
        members.TryTake(name, out SceneNode node) ? node.Vector() : Vector2.Zero;

    private static b2Joint JointOf(SceneObject members, string name, WorldContents contents)
    {
        SceneNode node = members.Take(name);
        return Scenes.SceneReader.ItemAt(node, contents.Joints, node.Whole());
    }

    // Looked at, not taken: they stand among the numbers as well.
    private static b2Vec2 Ground(SceneObject members, string x, string y) =>
        new b2Vec2((float)members.Look(x, 0), (float)members.Look(y, 0));
}
