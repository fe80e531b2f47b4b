using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Judging;

/// <summary>
/// One body falling on a flat static floor: its equations of motion from event to event. Its feet are the circles of its
/// geoms and the corners of its boxes (circles of radius 0); y points down, a foot's centre is q from the body's centre, so
/// the point it stands on is r = q + (0, R). A force (T, -N) there, with the default drags c v and c w|w|, gives
/// x'' = (T - c x') / m, y'' = g - (N + c y') / m, w' = (-rx N - ry T - c w|w|) / I. The foot closes in with n = y' + w rx
/// and slides with t = x' - w ry, which change by n' = n0 - (1/m + rx^2/I) N - (rx ry / I) T and
/// t' = t0 + (rx ry / I) N + (1/m + ry^2/I) T, where n0, t0 hold gravity, drag and the turning of q:
/// n0 = g - c y'/m + w0' rx - w^2 qy, t0 = -c x'/m - w0' ry - w^2 qx. Standing (n' = 0) it sticks (t' = 0, |T| no more than
/// mu N) or slides on (T = -mu N against t). An impact without restitution is the same with impulses: n becomes 0, and
/// t 0 or mu N short of it. Between events (a foot touches, lifts, starts or stops to slide) the motion is smooth:
/// Runge-Kutta steps of fourth order, the events by bisection.
/// </summary>
/// <remarks>
/// A foot stands on the floor's surface, from the first touch on. That it sinks to AllowedPenetration at rest moves the
/// body by less than every limit here, which have that depth on top.
/// </remarks>
public sealed class FallingBody
{
    /// <summary>Halving it moves no number by more than 1e-9 (tested).</summary>
    public const double DefaultStep = 1e-3;

    private const double Drag = 0.001;

    /// <summary>Gaps and speeds below this are none: rounding leaves them at 1e-13, the events of the scenes are far larger.</summary>
    private const double None = 1e-9;

    private readonly double _mass;
    private readonly double _inertia;
    private readonly double _gravity;
    private readonly double _friction;
    private readonly double _floor;
    private readonly Foot[] _feet;
    private readonly Motion _start;

    private FallingBody(SceneFile file, string body)
    {
        MadeObject made = file.Bodies.Single(b => b.Id == body);
        MadeObject floor = file.Bodies.Single(b => b.Id != body);
        (double width, double height) = Size(made);
        JsonElement position = Value(made, "position");
        JsonElement turned = Value(made, "rotation");
        _mass = Json.Required(made.Args, "mass").GetDouble();
        _inertia = _mass * ((width * width) + (height * height)) / 12;
        _gravity = Impacts.Gravity(file);
        _floor = Value(floor, "position")[1].GetDouble() - (Size(floor).Height / 2);
        _feet = file.Geoms.Where(g => g.Body == body).SelectMany(Feet).ToArray();
        _friction = file.Geoms.Select(g => Value(g, "frictionCoefficient").GetDouble()).Distinct().Single();
        _start = new Motion(
            position[0].GetDouble(), position[1].GetDouble(), turned.ValueKind == JsonValueKind.Number ? turned.GetDouble() : 0, 0, 0, 0);
    }

    /// <summary>The state of the body a time after its start from rest.</summary>
    public static Row At(SceneFile file, string body, double time) => At(file, body, time, DefaultStep);

    public static Row At(SceneFile file, string body, double time, double step)
    {
        Motion end = new FallingBody(file, body).Run(time, step);
        return new Row(end.X, end.Y, end.Angle, end.VelocityX, end.VelocityY, end.Spin);
    }

    private Motion Run(double time, double step)
    {
        Motion motion = _start;
        Stand stand = default;
        double now = 0;
        while (now < time && !stand.AtRest)
        {
            double most = Math.Min(step, time - now);
            Motion next = Step(motion, stand, most);
            if (Continues(next, stand))
            {
                motion = next;
                now = most < step ? time : now + step;
                continue;
            }

            double before = 0;
            double after = most;
            for (double middle = after / 2; middle > before && middle < after; middle = (before + after) / 2)
            {
                (before, after) = Continues(Step(motion, stand, middle), stand) ? (middle, after) : (before, middle);
            }

            // Just after the event, where what ended it can be told.
            motion = Impact(Step(motion, stand, after));
            now += after;
            stand = StandOf(motion);
        }

        return motion;
    }

    private bool Continues(in Motion motion, in Stand stand)
    {
        foreach (Foot foot in _feet)
        {
            if (foot != stand.Foot && Gap(motion, foot) < 0 && Speeds(motion, foot).Closing > 0)
            {
                return false;
            }
        }

        if (stand.Foot is not { } standing)
        {
            return true;
        }

        (double normal, double tangent) = Force(motion, stand);
        return normal >= 0 && (stand.Slides == 0
            ? Math.Abs(tangent) <= _friction * normal
            : Speeds(motion, standing).Sliding * stand.Slides >= -None);
    }

    /// <summary>
    /// The motion after the impulses of an inelastic impact: of one foot, sticking or sliding, if the others that touch do not
    /// close in then; otherwise two feet stop the body, which fixes both normal impulses and the sum of the tangential ones.
    /// </summary>
    private Motion Impact(Motion motion)
    {
        Foot[] touching = _feet.Where(f => Gap(motion, f) <= None).ToArray();
        if (touching.All(f => Speeds(motion, f).Closing <= None))
        {
            return motion;
        }

        foreach (Foot foot in touching)
        {
            foreach (int slides in new[] { 0, 1, -1 })
            {
                (double closing, double sliding) = Speeds(motion, foot);
                (double normal, double tangent) = Push(motion, foot, closing, sliding, slides);
                Motion after = Pushed(motion, foot, normal, tangent);
                bool allowed = slides == 0 ? Math.Abs(tangent) <= _friction * normal : Speeds(after, foot).Sliding * slides >= 0;
                if (normal >= 0 && allowed && touching.All(f => Speeds(after, f).Closing <= None))
                {
                    return after;
                }
            }
        }

        // m y' and m x' are the sums of the impulses, and -I w is the sum of their moments less that of the tangential ones.
        double down = _mass * motion.VelocityY;
        double along = -_mass * motion.VelocityX;
        return StandsOnTwo(motion, down, (_inertia * motion.Spin) - (touching[0].Arm(motion.Angle).Y * along)) && Math.Abs(along) <= _friction * down
            ? motion with { VelocityX = 0, VelocityY = 0, Spin = 0 }
            : throw new BadSceneException("two feet slide at once, which this closed form does not know");
    }

    private Stand StandOf(in Motion motion)
    {
        foreach (Foot foot in _feet)
        {
            (double closing, double sliding) = Speeds(motion, foot);
            if (Gap(motion, foot) > None || Math.Abs(closing) > None)
            {
                continue;
            }

            if (motion is { VelocityX: 0, VelocityY: 0, Spin: 0 } && StandsOnTwo(motion, _mass * _gravity, 0))
            {
                return new Stand(null, 0, AtRest: true);
            }

            foreach (int slides in Math.Abs(sliding) > None ? [Math.Sign(sliding)] : new[] { 0, 1, -1 })
            {
                Stand stand = new(foot, slides, AtRest: false);
                (double normal, double tangent) = Force(motion, stand);
                Motion after = Step(motion, stand, None);
                bool allowed = slides == 0 ? Math.Abs(tangent) <= _friction * normal : Speeds(after, foot).Sliding * slides >= 0;
                if (normal >= 0 && allowed)
                {
                    return stand;
                }
            }
        }

        return default;
    }

    /// <summary>Whether the outermost touching feet can carry a load together with its moment, each by pushing.</summary>
    private bool StandsOnTwo(Motion motion, double load, double moment)
    {
        double[] arms = _feet.Where(f => Gap(motion, f) <= None).Select(f => f.Arm(motion.Angle).X).ToArray();
        return arms.Min() * load <= moment && moment <= arms.Max() * load && arms.Min() < arms.Max();
    }

    private double Gap(in Motion motion, Foot foot) => _floor - motion.Y - foot.Arm(motion.Angle).Y;

    private static (double Closing, double Sliding) Speeds(in Motion motion, Foot foot)
    {
        (double x, double y) = foot.Arm(motion.Angle);
        return (motion.VelocityY + (motion.Spin * x), motion.VelocityX - (motion.Spin * y));
    }

    private (double Normal, double Tangent) Force(in Motion motion, in Stand stand)
    {
        if (stand.Foot is not { } foot)
        {
            return (0, 0);
        }

        (double x, double y) = foot.Arm(motion.Angle);
        Motion free = Rate(motion, null, 0, 0);
        double square = motion.Spin * motion.Spin;
        return Push(
            motion,
            foot,
            free.VelocityY + (free.Spin * x) - (square * (y - foot.Radius)),
            free.VelocityX - (free.Spin * y) - (square * x),
            stand.Slides);
    }

    /// <summary>The force (or impulse) at a foot that brings its closing to 0, with its sliding brought to 0 or rubbed against.</summary>
    private (double Normal, double Tangent) Push(in Motion motion, Foot foot, double closing, double sliding, int slides)
    {
        (double x, double y) = foot.Arm(motion.Angle);
        double normal = (1 / _mass) + (x * x / _inertia);
        double tangent = (1 / _mass) + (y * y / _inertia);
        double cross = x * y / _inertia;
        if (slides != 0)
        {
            double push = closing / (normal - (slides * _friction * cross));
            return (push, -slides * _friction * push);
        }

        double determinant = (normal * tangent) - (cross * cross);
        return (((closing * tangent) + (sliding * cross)) / determinant, -((sliding * normal) + (closing * cross)) / determinant);
    }

    private Motion Pushed(in Motion motion, Foot foot, double normal, double tangent)
    {
        (double x, double y) = foot.Arm(motion.Angle);
        return motion with
        {
            VelocityX = motion.VelocityX + (tangent / _mass),
            VelocityY = motion.VelocityY - (normal / _mass),
            Spin = motion.Spin - (((x * normal) + (y * tangent)) / _inertia),
        };
    }

    private Motion Rate(in Motion motion, Foot? foot, double normal, double tangent)
    {
        Motion free = new(
            motion.VelocityX,
            motion.VelocityY,
            motion.Spin,
            -Drag * motion.VelocityX / _mass,
            _gravity - (Drag * motion.VelocityY / _mass),
            -Drag * motion.Spin * Math.Abs(motion.Spin) / _inertia);
        if (foot is null)
        {
            return free;
        }

        Motion pushed = Pushed(motion, foot, normal, tangent);
        return free with
        {
            VelocityX = free.VelocityX + pushed.VelocityX - motion.VelocityX,
            VelocityY = free.VelocityY + pushed.VelocityY - motion.VelocityY,
            Spin = free.Spin + pushed.Spin - motion.Spin,
        };
    }

    private Motion Step(in Motion motion, in Stand stand, double step)
    {
        Motion first = Rate(motion, stand);
        Motion second = Rate(motion.Plus(first, step / 2), stand);
        Motion third = Rate(motion.Plus(second, step / 2), stand);
        Motion fourth = Rate(motion.Plus(third, step), stand);
        return motion.Plus(first, step / 6).Plus(second, step / 3).Plus(third, step / 3).Plus(fourth, step / 6);
    }

    private Motion Rate(in Motion motion, in Stand stand)
    {
        (double normal, double tangent) = Force(motion, stand);
        return Rate(motion, stand.Foot, normal, tangent);
    }

    private static IEnumerable<Foot> Feet(MadeObject geom)
    {
        (double x, double y) = geom.Args.TryGetProperty("offset", out JsonElement offset)
            ? (offset[0].GetDouble(), offset[1].GetDouble())
            : (0, 0);
        if (geom.Factory == "CreateCircleGeom")
        {
            return [new Foot(x, y, SceneSizes.Radius(geom))];
        }

        (double width, double height) = Size(geom);
        return new[] { (-1, 1), (1, 1), (-1, -1), (1, -1) }.Select(c => new Foot(x + (c.Item1 * width / 2), y + (c.Item2 * height / 2), 0));
    }

    private static (double Width, double Height) Size(MadeObject made)
        => (Json.Required(made.Args, "width").GetDouble(), Json.Required(made.Args, "height").GetDouble());

    private static JsonElement Value(MadeObject made, string name) => made.Properties.FirstOrDefault(p => p.Key == name).Value;

    /// <summary>A circle fixed to the body; a corner has radius 0.</summary>
    private sealed record Foot(double X, double Y, double Radius)
    {
        /// <summary>From the body's centre to the foot's lowest point, turned into the world.</summary>
        public (double X, double Y) Arm(double angle)
        {
            (double sin, double cos) = Math.SinCos(angle);
            return ((X * cos) - (Y * sin), (X * sin) + (Y * cos) + Radius);
        }
    }

    /// <summary>The foot the body stands on (null: none), the sign of its sliding, and whether the body has come to rest.</summary>
    private readonly record struct Stand(Foot? Foot, int Slides, bool AtRest);

    private readonly record struct Motion(double X, double Y, double Angle, double VelocityX, double VelocityY, double Spin)
    {
        public Motion Plus(in Motion rate, double time) => new(
            X + (rate.X * time),
            Y + (rate.Y * time),
            Angle + (rate.Angle * time),
            VelocityX + (rate.VelocityX * time),
            VelocityY + (rate.VelocityY * time),
            Spin + (rate.Spin * time));
    }
}
