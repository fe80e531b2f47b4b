using System;
using System.Collections.Generic;
using Farseer.Engine.Joints;
using Farseer.Engine.Storage;
using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Farseer.Engine.Tests.Joints;

/// <summary>The lists of joints of each body, and which bodies are tied, set beside what all joints together tell.</summary>
public class JointStoreTests
{
    private const int Bodies = 5;

    [Fact]
    public void Lists_WhateverCameWentOrChanged_HoldTheJointsOfEachBodyLastFirst_AndItsTies()
    {
        Prop.ForAll(
            Gen.ArrayOf(Gen.Choose(0, int.MaxValue)).ToArbitrary(),
            edits =>
            {
                var store = new JointStore();
                var alive = new List<Handle>();
                foreach (int edit in edits)
                {
                    Edit(store, alive, new Random(edit));
                    for (int body = 0; body < Bodies; body++)
                    {
                        Compare(store, alive, body);
                    }
                }
            }).QuickCheckThrowOnFailure();
    }

    private static void Edit(JointStore store, List<Handle> alive, Random random)
    {
        int kind = random.Next(5);
        if (kind < 2 || alive.Count == 0)
        {
            int a = random.Next(Bodies);
            int b = (a + 1 + random.Next(Bodies - 1)) % Bodies;
            JointKind of = random.Next(2) == 0 ? JointKind.Revolute : JointKind.Angle;
            alive.Add(store.Add(of, a, b, default, random.Next(4) > 0 ? JointFlags.Enabled : JointFlags.None));
            return;
        }

        int at = random.Next(alive.Count);
        Handle joint = alive[at];
        if (kind == 2)
        {
            store.Remove(joint);
            alive.RemoveAt(at);
        }
        else
        {
            JointFlags changed = kind == 3 ? JointFlags.Enabled : JointFlags.Spring;
            store.Flags[joint.Index] ^= changed;
            store.NoteTie(joint.Index);
        }
    }

    private static void Compare(JointStore store, List<Handle> alive, int body)
    {
        var wanted = new List<int>();
        bool tied = false;
        for (int i = alive.Count - 1; i >= 0; i--)
        {
            JointLink link = store.Links[alive[i].Index];
            if (link.BodyA == body || link.BodyB == body)
            {
                wanted.Add((2 * alive[i].Index) + (link.BodyA == body ? 0 : 1));
                tied |= store.IsTie(alive[i].Index);
            }
        }

        var found = new List<int>();
        for (int entry = store.First(body); entry >= 0; entry = store.Next(entry))
        {
            found.Add(entry);
        }

        Assert.Equal(wanted, found);
        Assert.Equal(wanted.Count, store.Degree(body));
        Assert.Equal(tied, store.IsTied(body));
    }
}
