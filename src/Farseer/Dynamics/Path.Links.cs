using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;
using FarseerGames.FarseerPhysics.Factories;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <content>What holds the links together.</content>
public partial class Path
{
    private const float LinkBias = 0.2f;
    private const float LinkSoftness = 0.01f;

    /// <summary>
    /// Links each body with the next one, and, if there are more than two, the last of an endless path with the first. Hinges sit midway
    /// between the centres. All others join the ends that face each other: pins keep them at the distance they have, springs rest at it.
    /// The joints get <see cref="Joint.BiasFactor"/> 0.2 and <see cref="Joint.Softness"/> 0.01. Each call adds links, so hinges and springs
    /// can be had together. <see cref="Farseer201Quirks.PathLinkedAtFarEnds"/> in <see cref="ComplexFactory.Quirks"/> links as version
    /// 2.0.1 did.
    /// </summary>
    /// <param name="type">The kind of link.</param>
    /// <param name="min">Smallest distance of the ends at a slider; at least 0.</param>
    /// <param name="max">Largest distance of the ends at a slider; at least 0, and not below <paramref name="min"/>.</param>
    /// <param name="springConstant">Force per length of a spring; at least 0.</param>
    /// <param name="dampingConstant">Force per speed of a spring; at least 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of its range, or the kind is not a member of its enum.</exception>
    /// <exception cref="ObjectDisposedException">A body is disposed.</exception>
    public void LinkBodies(LinkType type, float min, float max, float springConstant, float dampingConstant) =>
        Join(type, min, max, springConstant, dampingConstant, ComplexFactory.Instance.Quirks);

    internal void Join(LinkType type, float min, float max, float springConstant, float dampingConstant, Farseer201Quirks quirks)
    {
        CheckLinks(type, min, max, springConstant, dampingConstant);
        bool atFarEnds = (quirks & Farseer201Quirks.PathLinkedAtFarEnds) != 0;
        var joints = new List<Joint>();
        var springs = new List<Spring>();
        for (int i = 0; i + 1 < Bodies.Count; i++)
        {
            Link(Bodies[i], Bodies[i + 1], atFarEnds && i > 0);
        }

        if (_endless && Bodies.Count > 2)
        {
            Link(Bodies[0], Bodies[Bodies.Count - 1], atFarEnds);
        }

        // Only now: a body that is disposed has stopped the loop before anything of it was kept.
        _made.UnionWith(joints);
        _made.UnionWith(springs);
        joints.ForEach(Joints.Add);
        springs.ForEach(Springs.Add);

        void Link(Body first, Body second, bool asLongAsWide)
        {
            Vector2 end1 = atFarEnds ? new Vector2(-_width / 2, 0) : End(first, second);
            Vector2 end2 = atFarEnds ? new Vector2(_width / 2, 0) : End(second, first);
            switch (type)
            {
                case LinkType.RevoluteJoint:
                    joints.Add(
                        Firm(JointFactory.Instance.CreateRevoluteJoint(first, second, FindMidpoint(first.Position, second.Position))));
                    break;
                case LinkType.PinJoint:
                    PinJoint pin = Firm(JointFactory.Instance.CreatePinJoint(first, end1, second, end2));
                    pin.TargetDistance = asLongAsWide ? _width : pin.TargetDistance;
                    joints.Add(pin);
                    break;
                case LinkType.SliderJoint:
                    joints.Add(Firm(JointFactory.Instance.CreateSliderJoint(first, end1, second, end2, min, max)));
                    break;
                default:
                    LinearSpring spring =
                        SpringFactory.Instance.CreateLinearSpring(first, end1, second, end2, springConstant, dampingConstant);
                    spring.RestLength = asLongAsWide ? _width : spring.RestLength;
                    springs.Add(spring);
                    break;
            }
        }
    }

    private static T Firm<T>(T joint)
        where T : Joint
    {
        joint.BiasFactor = LinkBias;
        joint.Softness = LinkSoftness;
        return joint;
    }

    private static void CheckLinks(LinkType type, float min, float max, float springConstant, float dampingConstant)
    {
        if (type < LinkType.RevoluteJoint || type > LinkType.LinearSpring)
        {
            throw Require.Range(nameof(type), type, "must be a member of LinkType");
        }

        Require.NotNegative(min, nameof(min));
        Require.NotNegative(max, nameof(max));
        Require.NotNegative(springConstant, nameof(springConstant));
        Require.NotNegative(dampingConstant, nameof(dampingConstant));
        if (type == LinkType.SliderJoint)
        {
            Require.NotBelow(max, min, nameof(max));
        }
    }

    /// <summary>The end of a link that faces another one, in the link's coordinates.</summary>
    private Vector2 End(Body of, Body towards) => new Vector2(of.GetLocalPosition(towards.Position).X < 0 ? -_width / 2 : _width / 2, 0);
}
