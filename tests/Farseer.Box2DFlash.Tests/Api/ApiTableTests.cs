using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using Box2D.Dynamics;
using Xunit;
using Xunit.Abstractions;

namespace Farseer.Box2DFlash.Tests.Api;

/// <summary>Compares the public API with that of the original (tests/data/box2dflash-2.0.2-api.tsv).</summary>
public sealed class ApiTableTests(ITestOutputHelper output)
{
    /// <summary>Classes that are not there, by the reason.</summary>
    private static readonly Dictionary<string, string> _absentClasses = new(StringComparer.Ordinal)
    {
        ["ClipVertex b2Collision b2Distance b2TimeOfImpact b2Point b2Manifold "
            + "b2ManifoldPoint"] = "the original's narrow phase; the engine has its own",
        ["b2Bound b2BoundValues b2BroadPhase b2BufferedPair b2Pair b2PairCallback b2PairManager b2Proxy "
            + "b2ContactManager"] = "the original's broad phase",
        ["b2Island b2TimeStep b2ContactSolver b2ContactConstraint b2ContactConstraintPoint b2Jacobian b2Sweep"] = "the original's solver",
        ["b2CircleContact b2PolyAndCircleContact b2PolygonContact b2ContactEdge "
            + "b2ContactRegister"] = "one class of contact is enough where the engine collides the shapes",
    };

    /// <summary>Members that are not there, by the reason; "*" ends a beginning.</summary>
    private static readonly Dictionary<string, string> _absentMembers = new(StringComparer.Ordinal)
    {
        ["Features._* b2ContactID._key b2RevoluteJoint.tImpulse b2Contact.s_* "
            + "b2Contact.e_*"] = "fields behind properties, and states of the original's solver",
        ["b2Shape.Create* b2Shape.Destroy* b2Shape.RefilterProxy b2Shape.Synchronize "
            + "*.UpdateSweepRadius"] = "called by the original's world; the engine keeps its shapes up to date",
        ["b2Joint.Create b2Joint.Destroy *.InitVelocityConstraints *.InitPositionConstraints *.SolveVelocityConstraints "
            + "*.SolvePositionConstraints"] = "the original's solver",
        ["b2Body.Advance b2Body.SynchronizeShapes b2Body.SynchronizeTransform b2World.Solve b2World.SolveTOI "
            + "b2World.Validate"] = "the original's solver and its checks of itself",
        ["b2World.DrawJoint b2World.DrawShape"] = "parts of DrawDebugData",
        ["b2Contact.AddType b2Contact.Create b2Contact.Destroy *.Evaluate *.GetManifolds b2Contact.Update "
            + "b2Contact.InitializeRegisters"] = "the engine collides the shapes; points come by the listener",
        ["b2Body.b2Body b2Shape.b2Shape b2CircleShape.b2CircleShape b2PolygonShape.b2PolygonShape b2Contact.b2Contact "
            + "b2NullContact.b2NullContact b2Joint.b2Joint b2DistanceJoint.b2DistanceJoint b2GearJoint.b2GearJoint "
                + "b2MouseJoint.b2MouseJoint b2PrismaticJoint.b2PrismaticJoint b2PulleyJoint.b2PulleyJoint "
                    + "b2RevoluteJoint.b2RevoluteJoint "
                        + "b2JointDef.b2JointDef"] = "made by the world and the bodies only; definitions of no kind make no sense",
    };

    [Fact]
    public void Api_OfTheOriginal_IsThere()
    {
        List<string> missing = [];
        int absent = 0;
        foreach (string[] row in TestData.Table("box2dflash-2.0.2-api.tsv"))
        {
            string key = row[1] + "." + Plain(row[3]);
            if (IsListed(_absentClasses.Keys, row[1]) || (row[2] != "class" && IsListed(_absentMembers.Keys, key)))
            {
                absent++;
                continue;
            }

            Type? type = typeof(b2World).Assembly.GetType(row[0] + "." + row[1]);
            if (type is null || !(row[2] == "class" || Has(type, row)))
            {
                missing.Add(row[0] + " " + key);
            }
        }

        output.WriteLine($"{missing.Count} members are missing, {absent} are absent on purpose:");
        foreach ((string names, string reason) in _absentClasses.Concat(_absentMembers))
        {
            output.WriteLine($"{reason}: {names}");
        }

        Assert.True(missing.Count == 0, $"{missing.Count} members are missing:\n{string.Join('\n', missing)}");
    }

    [Fact]
    public void AbsentClasses_AreAbsent_AndOfTheOriginal()
    {
        string[] known = [.. TestData.Table("box2dflash-2.0.2-api.tsv").Select(r => r[1]).Distinct()];

        Assert.All(_absentClasses.Keys.SelectMany(k => k.Split(' ')), name =>
        {
            Assert.Contains(name, known);
            Assert.DoesNotContain(typeof(b2World).Assembly.GetExportedTypes(), t => t.Name == name);
        });
    }

    private static string Plain(string member) =>
        member.StartsWith("get ", StringComparison.Ordinal) || member.StartsWith("set ", StringComparison.Ordinal)
        ? member[4..]
        : member;

    private static bool IsListed(IEnumerable<string> lists, string key) => lists.SelectMany(l => l.Split(' ')).Any(pattern =>
        pattern == key
        || (pattern.EndsWith('*') && key.StartsWith(pattern[..^1], StringComparison.Ordinal))
        || (pattern.StartsWith("*.", StringComparison.Ordinal) && key.EndsWith(pattern[1..], StringComparison.Ordinal)));

    private static bool Has(Type type, string[] row)
    {
        const BindingFlags All = BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.FlattenHierarchy;
        string name = Plain(row[3]);
        if (row[2] == "constructor")
        {
            return type.GetConstructors().Length > 0;
        }

        if (row[2] == "method" && name == row[3])
        {
            int arguments = row[4].Split('(', 2)[1].Split(')')[0].Split(',', StringSplitOptions.RemoveEmptyEntries).Length;
            return type.GetMethods(All).Any(m => m.Name == name && m.GetParameters().Length == arguments);
        }

        return type.GetProperty(name, All) is not null || type.GetField(name, All) is not null;
    }
}
