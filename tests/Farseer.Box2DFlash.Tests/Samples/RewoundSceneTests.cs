using System;
using System.Collections.Generic;
using System.Linq;
using Box2D.Common.Math;
using Box2D.Dynamics;
using Box2D.Dynamics.Contacts;
using Box2D.Dynamics.Joints;
using Farseer.Testbed;
using Farseer.Tests.Shared;
using Xunit;

namespace Farseer.Box2DFlash.Tests.Samples;

/// <summary>Scenes of the testbed that go back from every seventh step to an earlier one and forward again come to the same.</summary>
public sealed class RewoundSceneTests
{
    private const int Every = 7;

    public static TheoryData<string, int> Names
    {
        get
        {
            TheoryData<string, int> names = [];
            foreach (string name in SceneList.Makers.Select(m => m().Name))
            {
                names.Add(name, 1);
                names.Add(name, 2);
            }

            return names;
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Scene_BackFromEverySeventhStepAndForwardAgain_ShowsTheSame(string name, int workers)
    {
        TestScene scene = SceneList.Makers.Select(m => m()).Single(s => s.Name == name);
        b2World world = scene.World;
        world.SetWorkerCount(workers);
        var kept = new List<(b2WorldState State, OwnMemory Own)>();
        var values = new List<int>();
        for (int at = 0; at < scene.Steps; at++)
        {
            if (at % Every == 0)
            {
                kept.Add((world.Capture(), new OwnMemory(scene)));
            }

            scene.Step(at);
            values.Add(Values(world));
            if ((at + 1) % Every != 0)
            {
                continue;
            }

            int back = Math.Max(0, kept.Count - (kept.Count % 3 == 0 ? 4 : 1));
            world.Restore(kept[back].State);
            kept[back].Own.Restore();
            for (int again = Every * back; again <= at; again++)
            {
                scene.Step(again);
                Assert.True(values[again] == Values(world), $"from step {at + 1} back to {Every * back}: step {again + 1} is another one");
            }
        }
    }

    private static int Values(b2World world)
    {
        var hash = default(HashCode);
        hash.Add(world.MotionHash());
        for (b2Body? body = world.GetBodyList(); body is not null; body = body.GetNext())
        {
            Add(body.GetPosition());
            Add(body.GetWorldCenter());
            Add(body.GetLinearVelocity());
            hash.Add((body.GetAngle(), body.GetAngularVelocity(), body.GetMass(), body.GetInertia(), body.IsSleeping(), body.IsFrozen()));
        }

        for (b2Joint? joint = world.GetJointList(); joint is not null; joint = joint.GetNext())
        {
            Add(joint.GetAnchor1());
            Add(joint.GetAnchor2());
            Add(joint.GetReactionForce());
            hash.Add(joint.GetReactionTorque());
        }

        for (b2Contact? contact = world.GetContactList(); contact is not null; contact = contact.GetNext())
        {
            hash.Add((contact.GetManifoldCount(), contact.IsSolid()));
        }

        return hash.ToHashCode();

        void Add(b2Vec2 place) => hash.Add((place.x, place.y));
    }
}
