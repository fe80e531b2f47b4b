using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;
using static Farseer.Tests.Sandbox;

namespace Farseer.Tests.Robustness;

/// <summary>
/// Ten thousand steps in which every handler adds, removes, disposes, moves and refuses at random, changes the lists it is
/// given, and sometimes throws. What a handler may not do throws and changes nothing; the world stays whole.
/// </summary>
public class RandomHandlerTests
{
    private const int Steps = 10_000;
    private const int Least = 12;
    private const int Most = 40;

    public static TheoryData<string> Colliders => new() { "sweep", "prune", "brute", "grid" };

    [Theory]
    [MemberData(nameof(Colliders))]
    public void RandomChanges_InEveryHandler_LeaveAWholeWorld(string collider)
    {
        var riot = new Riot(collider, 12345);

        for (int step = 0; step < Steps / 4; step++)
        {
            riot.Advance();
        }

        riot.Calm();
        riot.CheckWhole();
        Assert.All(riot.Calls, call => Assert.True(call.Value > 20, call.Key + " was called " + call.Value + " times"));
    }

    [Fact]
    public void RandomChanges_WithTheSameSeed_EndInTheSameState()
    {
        ulong[] hashes = new ulong[2];
        for (int run = 0; run < 2; run++)
        {
            var riot = new Riot("sweep", 99);
            for (int step = 0; step < 1000; step++)
            {
                riot.Advance();
            }

            hashes[run] = riot.Simulator.StateHash();
        }

        Assert.Equal(hashes[0], hashes[1]);
    }

    private sealed class Riot
    {
        private readonly Random _random;
        private Geom _floor;
        private bool _calm;
        private int _depth;

        public Riot(string collider, int seed)
        {
            _random = new Random(seed);
            Simulator = new PhysicsSimulator(new Vector2(0, 100));
            Simulator.BroadPhaseCollider = collider switch
            {
                "prune" => new SweepAndPruneCollider(Simulator),
                "brute" => new BruteForceCollider(Simulator),
                "grid" => new GridCollider(Simulator),
                _ => Simulator.BroadPhaseCollider,
            };
            Simulator.BroadPhaseCollider.OnBroadPhaseCollision += (_, _) =>
            {
                Act("OnBroadPhaseCollision", null);
                return _calm || _random.Next(8) != 0;
            };
            Simulator.BodyList.Added += _ => Act("BodyList.Added", null);
            Simulator.BodyList.Removed += _ => Act("BodyList.Removed", null);
            Simulator.GeomList.Added += _ => Act("GeomList.Added", null);
            Simulator.GeomList.Removed += _ => Act("GeomList.Removed", null);
            _floor = Floor(Simulator);
            Simulator.Update(Step);
        }

        public PhysicsSimulator Simulator { get; }

        public SortedDictionary<string, int> Calls { get; } = new(StringComparer.Ordinal);

        public void Advance()
        {
            Tidy();
            if (Simulator.BodyList.Count < Least)
            {
                Spawn();
            }

            try
            {
                Simulator.Update(Step);
            }
            catch (FormatException)
            {
                // Thrown by a handler on purpose; the step is complete.
            }
        }

        public void Calm()
        {
            _calm = true;
            Simulator.Update(Step);
            Geom box = Box(Simulator, new Vector2(5000, 5000));
            box.Body.IgnoreGravity = true;
            Simulator.Update(Step);
            Simulator.Update(Step);
            Assert.Contains(box, Simulator.GeomList);
        }

        /// <summary>Lists, owners and states agree, and what is new falls and lands as it should.</summary>
        public void CheckWhole()
        {
            Assert.Equal(Simulator.BodyList.Count, Simulator.BodyList.Distinct().Count());
            Assert.Equal(Simulator.GeomList.Count, Simulator.GeomList.Distinct().Count());
            Assert.All(Simulator.BodyList, body =>
            {
                Assert.False(body.IsDisposed);
                Assert.True(float.IsFinite(body.Position.X) && float.IsFinite(body.Position.Y) && float.IsFinite(body.TotalRotation));
                Assert.True(float.IsFinite(body.LinearVelocity.Length()) && float.IsFinite(body.AngularVelocity));
            });
            Assert.All(Simulator.GeomList, geom =>
            {
                Assert.False(geom.IsDisposed);
                Assert.False(geom.Body.IsDisposed);
            });
            Assert.All(Simulator.ArbiterList, arbiter =>
            {
                Assert.Contains(arbiter.GeomA, Simulator.GeomList);
                Assert.Contains(arbiter.GeomB, Simulator.GeomList);
                Assert.NotEmpty(arbiter.ContactList);
            });

            Simulator.Clear();
            Assert.Empty(Simulator.BodyList);
            Assert.Empty(Simulator.GeomList);
            Assert.Empty(Simulator.ArbiterList);
            Floor(Simulator);
            Geom box = Box(Simulator, new Vector2(0, -30));
            Run(Simulator, 300);
            Assert.Equal(-9.95f, box.Body.Position.Y, 0.02f);
        }

        /// <summary>What has fallen past the floor or was left standing in the air goes, and a floor that a handler took away comes back.</summary>
        private void Tidy()
        {
            foreach (Body body in Simulator.BodyList.Where(IsSpent).ToList())
            {
                Simulator.Remove(body);
                for (int i = 0; i < body.GeomCount; i++)
                {
                    Simulator.Remove(body.GeomAt(i));
                }
            }

            if (!Simulator.GeomList.Contains(_floor) || !_floor.Body.Enabled || !_floor.Body.IsStatic || _floor.Body.Position.Y < 0)
            {
                Simulator.Remove(_floor);
                _floor = Floor(Simulator);
            }
        }

        private bool IsSpent(Body body) =>
            body.Position.Length() > 400 || (body != _floor.Body && (!body.Enabled || body.IsStatic) && _random.Next(20) == 0);

        private void Spawn()
        {
            var place = new Vector2(_random.Next(-150, 150), _random.Next(-200, -20));
            Geom geom = _random.Next(2) == 0 ? Box(Simulator, place) : Ball(Simulator, place, 9);
            geom.RestitutionCoefficient = _random.Next(2);
            geom.OnCollision += (first, second, contacts) =>
            {
                Act("OnCollision", _random.Next(2) == 0 ? first : second);
                if (!_calm && _random.Next(16) == 0)
                {
                    contacts.Clear();
                }

                return _calm || _random.Next(5) != 0;
            };
            geom.OnSeparation += (first, second) => Act("OnSeparation", _random.Next(2) == 0 ? first : second);
            geom.Body.Updated += (ref Vector2 _, ref float _) => Act("Updated", geom);
            geom.Body.Disposed += (_, _) => Act("Body.Disposed", null);
        }

        private void Act(string handler, Geom? near)
        {
            Calls.TryGetValue(handler, out int calls);
            Calls[handler] = calls + 1;

            // Disposing raises handlers in turn: without an end to it they would only call each other.
            if (_calm || _depth > 1 || _random.Next(12) != 0)
            {
                return;
            }

            _depth++;
            try
            {
                Change(near);
            }
            finally
            {
                _depth--;
            }
        }

        private void Change(Geom? near)
        {
            IList<Geom> geoms = Simulator.GeomList;
            Geom geom = near is { IsDisposed: false } ? near : geoms.Count > 0 ? geoms[_random.Next(geoms.Count)] : _floor;
            if (geom.IsDisposed || geom.Body.IsDisposed || (ReferenceEquals(geom, _floor) && _random.Next(50) != 0))
            {
                return;
            }

            switch (_random.Next(16))
            {
                case 0: Simulator.Remove(geom); break;
                case 1: Simulator.Remove(geom.Body); break;
                case 2: geom.Dispose(); break;
                case 3: geom.Body.Dispose(); break;
                case 4 when _random.Next(40) == 0: Simulator.Clear(); break;
                case 5 or 6 when Simulator.BodyList.Count < Most: Spawn(); break;
                case 7: geom.Body.Position += new Vector2(_random.Next(-20, 20), -15); break;
                case 8: geom.Body.Enabled = !geom.Body.Enabled; break;
                case 9: geom.Body.IsStatic = _random.Next(4) == 0; break;
                case 10: geom.CollisionGroup = _random.Next(3); break;
                case 11: geom.IsSensor = _random.Next(4) == 0; break;
                case 12: geom.SetVertices(Vertices.CreateRectangle(_random.Next(5, 25), 12)); break;
                case 13: Simulator.ArbiterList.Clear(); break;
                case 14: Assert.Throws<InvalidOperationException>(() => Simulator.Update(Step)); break;
                default: throw new FormatException("a handler's own");
            }
        }
    }
}
