using System;
using System.Collections.Generic;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Dynamics.Springs;

namespace Farseer.Tests.Robustness;

/// <content>What handlers do to it.</content>
internal sealed partial class RestlessWorld
{
    private void Change(Body? body, Geom? geom)
    {
        switch (_random.Next(6))
        {
            case 0:
                Exchange(body, geom);
                break;
            case 1 when geom is not null:
                Change(geom);
                break;
            case 2:
                Change(Pick(_joints, j => j.IsDisposed), Pick(_springs, s => s.IsDisposed));
                break;
            case 3:
                ChangeWorld();
                break;
            default:
                if (body is not null)
                {
                    Change(body);
                }

                break;
        }
    }

    /// <summary>Adds, removes and disposes.</summary>
    private void Exchange(Body? body, Geom? geom)
    {
        bool full = _simulator.BodyList.Count >= MostBodies;
        switch (_random.Next(14))
        {
            case 0 or 1 or 2 when !full: AddBody(); break;
            case 3 when body is not null: AddGeom(body); break;
            case 4 or 5: AddJoint(); break;
            case 6: AddSpring(); break;
            case 7: AddController(); break;
            case 8 when body is not null: _simulator.Remove(body); break;
            case 9 when geom is not null: _simulator.Remove(geom); break;
            case 10 when body is not null && full: body.Dispose(); break;
            case 11 when geom is not null: geom.Dispose(); break;
            case 12 when body is not null: _simulator.Add(body); break;
            case 13 when geom is not null: _simulator.Add(geom); break;
        }
    }

    private void Change(Body body)
    {
        switch (_random.Next(20))
        {
            case 0: body.Position += Around(); break;
            case 1: body.Position = Room * Around(); break;
            case 2: body.Rotation += Next(-1, 1); break;
            case 3: body.LinearVelocity = 10 * Around(); break;
            case 4: body.AngularVelocity = Next(-10, 10); break;
            case 5: body.ApplyForce(100 * Around()); break;
            case 6: body.ApplyImpulse(10 * Around()); break;
            case 7: body.ApplyForceAtLocalPoint(100 * Around(), Around()); break;
            case 8: body.ResetDynamics(); break;
            case 9: body.IsStatic = !body.IsStatic && _random.Next(3) == 0; break;
            case 10: body.IsKinematic = !body.IsKinematic; break;
            case 11: body.Enabled = !body.Enabled; break;
            case 12: body.Mass = MathF.Exp(Next(-3, 3)); break;
            case 13: body.MomentOfInertia = MathF.Exp(Next(-3, 3)); break;
            case 14: body.IterationFactor = _random.Next(3) == 0 ? 0 : 1 << _random.Next(5); break;
            case 15: body.IsBullet = Often(); break;
            case 16: body.Awake = Often(); break;
            case 17: body.IgnoreGravity = Often(); break;
            case 18: body.LinearDragCoefficient = Next(0, 1); break;
            default: body.IsAutoIdle = Often(); break;
        }
    }

    private void Change(Geom geom)
    {
        switch (_random.Next(10))
        {
            case 0: geom.SetVertices(Star(Next(0.3f, 1.4f))); break;
            case 1: geom.SetVertices(Vertices.CreateRectangle(Next(0.3f, 1.4f), Next(0.3f, 1.4f))); break;
            case 2 when Pick(_bodies, b => b.IsDisposed) is { } body: geom.SetBody(body); break;
            case 3: geom.IsSensor = _random.Next(3) == 0; break;
            case 4: geom.CollisionEnabled = _random.Next(4) != 0; break;
            case 5: geom.CollisionResponseEnabled = _random.Next(4) != 0; break;
            case 6: geom.CollisionGroup = _random.Next(-1, 3); break;
            case 7: geom.CollidesWith = (CollisionCategory)_random.Next(); break;
            case 8: geom.RestitutionCoefficient = Next(0, 1); break;
            default: geom.FrictionCoefficient = Next(0, 3); break;
        }
    }

    private void Change(Joint? joint, Spring? spring)
    {
        switch (_random.Next(10))
        {
            case 0 when joint is not null: _simulator.Remove(joint); break;
            case 1 when joint is not null: joint.Dispose(); break;
            case 2 when joint is not null: _simulator.Add(joint); break;
            case 3 when joint is not null: joint.Breakpoint = 0; break;
            case 4 when joint is not null: joint.CollideConnected = Often(); break;
            case 5 when joint is not null: joint.Softness = Often() ? 0.1f : 0; break;
            case 6 when joint is not null: joint.BiasFactor = Next(0, 1); break;
            case 7 when spring is not null: spring.Enabled = Often(); break;
            case 8 when spring is not null: _simulator.Remove(spring); break;
            default:
                if (joint is not null)
                {
                    joint.Enabled = !joint.Enabled;
                }

                break;
        }
    }

    private void ChangeWorld()
    {
        var found = new List<Geom>();
        var hits = new List<RayCastHit>();
        switch (_random.Next(18))
        {
            case 0: _simulator.Gravity = 10 * Around(); break;
            case 1: _simulator.ArbiterList.Clear(); break;
            case 2: _simulator.Iterations = _random.Next(1, 12); break;
            case 3: _simulator.AdaptIterations = Often(); break;
            case 4: _simulator.AllowSleep = Often(); break;
            case 5: _simulator.WorkerCount = _random.Next(1, 5); break;
            case 6: _simulator.AllowedPenetration = Next(0, 0.05f); break;
            case 7: _simulator.BiasFactor = Next(0, 1); break;
            case 8: _simulator.IsContinuousCollisionEnabled = Often(); break;
            case 9: _simulator.EnableReport = Often(); break;
            case 10: _simulator.RayCastAll(Room * Around(), Room * Around(), hits); break;
            case 11: _simulator.QueryCircle(Room * Around(), 2, found); break;
            case 12: _simulator.ClosestPoint(Room * Around(), 3, out _); break;
            case 13: _simulator.MaxContactsToResolve = _random.Next(1, 10); break;
            case 14 when Pick(_controllers, c => c.IsDisposed) is { } controller: _simulator.Remove(controller); break;
            case 15 when _random.Next(40) == 0: _simulator.Clear(); break;
            case 16: _simulator.Update(1 / 60f); break;
            default: throw new FormatException("a handler's own");
        }
    }
}
