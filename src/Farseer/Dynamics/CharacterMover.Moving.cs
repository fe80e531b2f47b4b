using System;
using System.Collections.Generic;
using System.Numerics;
using Farseer.Engine.Numerics;
using FarseerGames.FarseerPhysics.Bridge;
using FarseerGames.FarseerPhysics.Collisions;

namespace FarseerGames.FarseerPhysics.Dynamics;

/// <content>How it moves.</content>
public sealed partial class CharacterMover
{
    /// <summary>Surfaces that it slides along in a step, and turns of pushing it out of what has come into it.</summary>
    private const int MostSlides = 5;
    private const int MostPushes = 8;

    /// <summary>Share of the radius that it keeps from what it meets: a cast that starts in touch has no normal.</summary>
    private const double SkinShare = 0.01;

    /// <summary>Share of it below which it is pushed away: what it touches a cast would take for something that it is in.</summary>
    private const double LeastGap = 0.25;

    /// <summary>Cosine between the normal of a one-way surface and its direction from which on it holds.</summary>
    private const float LeastAlong = 0.5f;

    private readonly QueryFilter _filter;
    private readonly List<Geom> _passed = new List<Geom>();
    private readonly List<Geom> _touched = new List<Geom>();
    private double _x;
    private double _y;

    private double Skin => SkinShare * _radius;

    /// <summary>Finds the way of a step and gives the body the velocity that brings it there in the update that follows.</summary>
    /// <param name="dt">Length of the update, seconds; finite and above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="dt"/> is not finite or not above 0.</exception>
    /// <exception cref="ObjectDisposedException">The body is disposed.</exception>
    public void Move(float dt)
    {
        Require.Positive(dt, nameof(dt));
        Body.ThrowIfDisposed();
        Body.GetPosition(out _x, out _y);
        _passed.Clear();
        NotePassed();
        TouchesWall = false;
        bool wasGrounded = IsGrounded;
        Vector2 carry = GroundVelocity;
        Recover();
        PressGround(dt);
        Vector2 way = Fall(dt);
        bool rises = Vector2.Dot(_velocity, _up) > 0;
        Geom? ground = Ground;
        Vector2 groundNormal = GroundNormal;
        LeaveGround();
        if (wasGrounded && !rises)
        {
            way = AlongGround(way, groundNormal);
        }

        Slide(way, wasGrounded && !rises, dt);
        FindGround(!rises, wasGrounded ? Math.Max(_snapDistance, 2 * Skin) : 2 * Skin, dt);
        if (wasGrounded && !IsGrounded)
        {
            // It takes along what carried it.
            _velocity += carry;
        }

        if (ground is not null && !ground.IsDisposed && wasGrounded)
        {
            Ride(ground.Body, dt);
        }

        GroundVelocity = Ground is null ? Vector2.Zero : VelocityOf(Ground.Body);
        Body.GetPosition(out double x, out double y);
        Body.GetTotalRotation(out double rotation);
        Body.MoveTo(new Vector2((float)_x, (float)_y), rotation, dt);
        Body.LinearVelocity = new Vector2((float)((_x - x) / dt), (float)((_y - y) / dt));
    }

    private bool IsMet(Geom geom) => !_passed.Contains(geom)
        && (geom.CollisionCategories & Filter.Categories) != 0
        && (Filter.Accept is null || Filter.Accept(geom))
        && (geom.CollisionGroup == 0 || geom.CollisionGroup != Geom.CollisionGroup)
        && (geom.CollidesWith & Geom.CollisionCategories) != 0 && (Geom.CollidesWith & geom.CollisionCategories) != 0;

    /// <summary>One-way platforms that it is in are passed until it has left them.</summary>
    private void NotePassed()
    {
        _simulator.QueryGeom(Geom, _touched, _filter);
        foreach (Geom geom in _touched)
        {
            if (geom.OneWayDirection != Vector2.Zero)
            {
                _passed.Add(geom);
            }
        }
    }

    private Vector2 Fall(float dt)
    {
        if (!UsesGravity || (IsGrounded && Vector2.Dot(_velocity, _up) <= 0))
        {
            return _velocity * dt;
        }

        Vector2 gravity = _simulator.Gravity;
        Vector2 way = (_velocity * dt) + (0.5f * dt * dt * gravity);
        _velocity += gravity * dt;
        return way;
    }

    private void LeaveGround()
    {
        Ground = null;
        GroundNormal = Vector2.Zero;
    }

    /// <summary>As far along the slope as it was to go level.</summary>
    private Vector2 AlongGround(Vector2 way, Vector2 normal)
    {
        var side = new Vector2(_up.Y, -_up.X);
        var along = new Vector2(normal.Y, -normal.X);
        float level = Vector2.Dot(way, side);
        float cosine = Vector2.Dot(along, side);
        return cosine > 1e-3f ? along * (level / cosine) : side * level;
    }

    private void Slide(Vector2 way, bool grounded, float dt)
    {
        double x = way.X;
        double y = way.Y;
        for (int slide = 0; slide < MostSlides && (x * x) + (y * y) > 1e-12 * _radius * _radius; slide++)
        {
            if (!Cast(x, y, out RayCastHit hit))
            {
                _x += x;
                _y += y;
                return;
            }

            double left = 1 - Advance(x, y, hit);
            x *= left;
            y *= left;
            Vector2 normal = hit.Normal;
            bool walkable = IsWalkable(normal);
            if (!walkable)
            {
                Push(hit, dt);
                if (grounded && StepUp(x, y))
                {
                    return;
                }

                TouchesWall |= Math.Abs(Vector2.Dot(normal, _up)) < 0.9f;
                normal = grounded && Vector2.Dot(normal, _up) > 0 ? Level(normal) : normal;
            }

            Clip(walkable ? _up : normal);
            double into = (x * normal.X) + (y * normal.Y);
            if (into < 0)
            {
                x -= into * normal.X;
                y -= into * normal.Y;
            }
        }
    }

    /// <summary>A slope that is too steep is a wall to those who stand.</summary>
    private Vector2 Level(Vector2 normal)
    {
        Vector2 level = normal - (Vector2.Dot(normal, _up) * _up);
        return level.LengthSquared() > 1e-6f ? Vector2.Normalize(level) : normal;
    }

    private bool IsWalkable(Vector2 normal) => Vector2.Dot(normal, _up) >= (float)Cosine(_maxSlope) - 1e-4f;

    private static double Cosine(double angle)
    {
        StableMath.SinCos(angle, out _, out double cos);
        return cos;
    }

    /// <summary>Up, on, and down again, if there is something to stand on.</summary>
    private bool StepUp(double x, double y)
    {
        double startX = _x;
        double startY = _y;
        Vector2 feet = Feet;
        if (_stepHeight <= 0)
        {
            return false;
        }

        double rise = _stepHeight + (2 * Skin);
        double up = Cast(rise * _up.X, rise * _up.Y, out RayCastHit above) ? Math.Max(0, (rise * above.Fraction) - Skin) : rise;
        _x += up * _up.X;
        _y += up * _up.Y;

        // A little at least, so that a slow one gets its feet onto the edge.
        double length = Math.Sqrt((x * x) + (y * y));
        double least = Math.Max(length, 2 * Skin) / Math.Max(length, 1e-30);
        if (!Cast(x * least, y * least, out RayCastHit ahead))
        {
            _x += x * least;
            _y += y * least;
        }
        else
        {
            Advance(x * least, y * least, ahead);
        }

        double down = up + Skin;
        if (Cast(-down * _up.X, -down * _up.Y, out RayCastHit step) && !step.StartsInside && (IsWalkable(step.Normal) || IsEdge(step))
            && Vector2.Dot(step.Point - feet, _up) <= _stepHeight + (float)(2 * Skin))
        {
            Advance(-down * _up.X, -down * _up.Y, step);
            double risen = ((_x - startX) * _up.X) + ((_y - startY) * _up.Y);
            double gone = ((_x - startX) * _up.Y) - ((_y - startY) * _up.X);
            if (risen > Skin / 2 && Math.Abs(gone) > 1e-6 * _radius)
            {
                return true;
            }
        }

        _x = startX;
        _y = startY;
        return false;
    }

    /// <summary>The round feet touch the edge of something level: a ray from above tells.</summary>
    private bool IsEdge(in RayCastHit hit)
    {
        Vector2 inward = Level(-hit.Normal) * (float)(2 * Skin);
        Vector2 above = hit.Point + inward + (_up * _radius);
        return _simulator.RayCast(above, above - (_up * 1.5f * _radius), out RayCastHit flat, _filter)
            && !flat.StartsInside
            && IsWalkable(flat.Normal);
    }

    /// <summary>Whether there is ground under its feet, down to which it comes.</summary>
    private void FindGround(bool mayLand, double reach, float dt)
    {
        if (!mayLand || !Cast(-reach * _up.X, -reach * _up.Y, out RayCastHit hit) || hit.Geom is null)
        {
            return;
        }

        Push(hit, dt);
        if (!hit.StartsInside && (IsWalkable(hit.Normal) || IsEdge(hit)))
        {
            Advance(-reach * _up.X, -reach * _up.Y, hit);
            Ground = hit.Geom;
            GroundNormal = IsWalkable(hit.Normal) ? hit.Normal : _up;
            Clip(_up);
        }
    }

    /// <summary>Goes with what it stood on, turning too, as far as nothing is in the way.</summary>
    private void Ride(Body ground, float dt)
    {
        if (ground.IsStatic || !ground.Enabled)
        {
            return;
        }

        ground.GetPosition(out double centerX, out double centerY);
        double x = _x - centerX;
        double y = _y - centerY;
        StableMath.SinCos(ground.AngularVelocity * (double)dt, out double sin, out double cos);
        double wayX = (ground.LinearVelocity.X * (double)dt) + ((cos * x) - (sin * y) - x);
        double wayY = (ground.LinearVelocity.Y * (double)dt) + ((sin * x) + (cos * y) - y);
        int passed = _passed.Count;
        foreach (Geom geom in ground.Geoms)
        {
            _passed.Add(geom);
        }

        if (Cast(wayX, wayY, out RayCastHit hit))
        {
            Advance(wayX, wayY, hit);
        }
        else
        {
            _x += wayX;
            _y += wayY;
        }

        _passed.RemoveRange(passed, _passed.Count - passed);
    }

    /// <summary>Comes out of what has moved into it.</summary>
    private void Recover()
    {
        int points = 2 + (int)(_length / _radius);
        for (int turn = 0; turn < MostPushes; turn++)
        {
            bool any = false;
            for (int i = 0; i <= points; i++)
            {
                double along = _length * (((double)i / points) - 0.5);
                var point = new Vector2((float)(_x + (along * _up.X)), (float)(_y + (along * _up.Y)));
                if (!_simulator.ClosestPoint(point, (float)(_radius + Skin), out ClosestPointHit near, _filter)
                    || near.Distance >= _radius + (LeastGap * Skin))
                {
                    continue;
                }

                Vector2 away = near.Distance >= 0 ? point - near.Point : near.Point - point;
                if (away.LengthSquared() > 0)
                {
                    away = Vector2.Normalize(away);
                    double push = _radius + Skin - near.Distance;
                    _x += push * away.X;
                    _y += push * away.Y;
                    any = true;
                }
            }

            if (!any)
            {
                return;
            }
        }
    }

    /// <summary>A cast from where it is; one-way platforms that do not hold it are passed.</summary>
    private bool Cast(double x, double y, out RayCastHit hit)
    {
        while (true)
        {
            CapsuleWay way;
            way.AxisX = _length * _up.X;
            way.AxisY = _length * _up.Y;
            way.X = _x - (0.5 * way.AxisX);
            way.Y = _y - (0.5 * way.AxisY);
            way.Radius = _radius;
            way.WayX = x;
            way.WayY = y;
            using (QueryTurn turn = _simulator.Asking.Enter())
            {
                if (!turn.Link.CastCapsule(way, _filter, out hit) || hit.Geom is null)
                {
                    return false;
                }
            }

            if (!IsOpen(hit, x, y))
            {
                return true;
            }

            _passed.Add(hit.Geom);
        }
    }

    private bool IsOpen(in RayCastHit hit, double x, double y)
    {
        Vector2 local = hit.Geom!.OneWayDirection;
        if (local == Vector2.Zero)
        {
            // What it is in and could not come out of does not hold it for ever.
            return hit.StartsInside;
        }

        Body body = hit.Geom.Body;
        Vector2 along = Vector2.Normalize((local.X * body.XVectorInWorldCoordinates) + (local.Y * body.YVectorInWorldCoordinates));
        return DropsThrough || hit.StartsInside || Vector2.Dot(hit.Normal, along) < LeastAlong || (x * along.X) + (y * along.Y) > 0;
    }

    /// <summary>
    /// Goes up to a hit, but for the skin. What can be moved keeps as far away as the last substep comes: the solver looks one ahead and
    /// would push it with all the force that a kinematic body has.
    /// </summary>
    /// <returns>The share of the way that it goes.</returns>
    private double Advance(double x, double y, in RayCastHit hit)
    {
        double length = Math.Sqrt((x * x) + (y * y));
        if (!(length > 0))
        {
            return 0;
        }

        double facing = -((x * hit.Normal.X) + (y * hit.Normal.Y)) / length;
        double back = facing > 0 ? Skin / Math.Max(facing, 0.1) : 0;
        double gone = Math.Max(0, (length * hit.Fraction) - back) / length;
        gone *= hit.Geom!.Body.InverseMass > 0 ? _simulator.Iterations / (_simulator.Iterations + 1.0) : 1;
        _x += gone * x;
        _y += gone * y;
        return gone;
    }

    /// <summary>Takes what leads into a surface out of the velocity.</summary>
    private void Clip(Vector2 normal)
    {
        float into = Vector2.Dot(_velocity, normal);
        if (into < 0)
        {
            _velocity -= into * normal;
        }
    }

    /// <summary>Pushes a body that is in the way, up to its own speed and no harder than it may.</summary>
    private void Push(in RayCastHit hit, float dt)
    {
        Body body = hit.Geom!.Body;
        if (_pushForce == 0 || body.InverseMass == 0 || hit.StartsInside)
        {
            return;
        }

        Vector2 point = hit.Point;
        body.GetVelocityAtWorldPoint(ref point, out Vector2 velocity);
        float closing = -Vector2.Dot(_velocity - velocity, hit.Normal);
        if (closing > 0)
        {
            body.ApplyImpulseAtWorldPoint(-Math.Min(_pushForce * dt, closing * body.Mass) * hit.Normal, point);
        }
    }

    /// <summary>Its weight presses on what it stands on.</summary>
    private void PressGround(float dt)
    {
        if (_mass > 0 && Ground is { IsDisposed: false } ground && ground.Body.InverseMass > 0)
        {
            ground.Body.ApplyImpulseAtWorldPoint(_mass * dt * _simulator.Gravity, Feet);
        }
    }

    private Vector2 Feet => new Vector2((float)_x, (float)_y) - ((_radius + (0.5f * _length)) * _up);

    private Vector2 VelocityOf(Body ground)
    {
        if (ground.IsStatic)
        {
            return Vector2.Zero;
        }

        Vector2 feet = Feet;
        ground.GetVelocityAtWorldPoint(ref feet, out Vector2 velocity);
        return velocity;
    }
}
