using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;

namespace Farseer.Scenes;

/// <summary>What the scenes of paths share.</summary>
internal static class Chains
{
    /// <summary>Takes away the give that the factory gives to chains, and the drag.</summary>
    public static void Harden(Path path)
    {
        foreach (Joint joint in path.Joints)
        {
            joint.Softness = 0f;
            joint.BiasFactor = 0.2f;
        }

        foreach (Body body in path.Bodies)
        {
            Make.NoDrag(body);
        }
    }

    public static void SetFriction(Path path, float friction)
    {
        foreach (Geom geom in path.Geoms)
        {
            geom.FrictionCoefficient = friction;
        }
    }

    /// <summary>Largest distance of the two anchors of a hinge or nail, from the poses of the bodies.</summary>
    public static double WidestGap(Path path)
    {
        double widest = 0.0;
        foreach (Joint joint in path.Joints)
        {
            widest = double.IsNaN(joint.JointError) ? double.NaN : Math.Max(widest, Math.Abs(joint.JointError));
        }

        return widest;
    }

    /// <summary>Hangs one end of a path on a nail.</summary>
    public static FixedRevoluteJoint Nail(Path path, Body body, Vector2 place)
    {
        FixedRevoluteJoint nail = new(body, place);
        path.Add(nail);
        return nail;
    }
}
