using System;
using System.Linq;
using System.Text.Json;
using Farseer.Fidelity.Scenes;

namespace Farseer.Fidelity.Fine;

/// <summary>
/// A spring of Farseer Physics 2.0 between points of two bodies, or of the world and a body: force -(k x + c v) along the line between
/// them,
/// x beyond the rest length; or a torsion bar, whose torque on a body is -k x less c times that body's own spin. It is judged against its
/// Breakpoint when a step begins, by the error at the begin of the step before, and still pulls in the step in which it breaks.
/// </summary>
internal sealed class FineSpring : IFinePull
{
    private readonly FineBody? _first;
    private readonly FineBody _second;
    private readonly (double X, double Y) _at1;
    private readonly (double X, double Y) _at2;
    private readonly bool _turns;
    private readonly double _stiffness;
    private readonly double _damping;
    private readonly double _rest;
    private readonly double _most;
    private double _error;
    private bool _breaks;
    private bool _broken;

    private FineSpring(MadeObject spring, Func<string, FineBody> find)
    {
        JsonElement args = spring.Args;
        bool hasTwo = Json.OptionalText(args, "body1") is not null;
        _turns = spring.Factory.Contains("Angle", StringComparison.Ordinal);
        _first = hasTwo ? find(Json.Text(args, "body1")) : null;
        _second = find(Json.Text(args, hasTwo ? "body2" : "body"));
        _at1 = Point(args, hasTwo ? "attachPoint1" : "worldAttachPoint");
        _at2 = Point(args, hasTwo ? "attachPoint2" : "bodyAttachPoint");
        _stiffness = Json.Required(args, "springConstant").GetDouble();
        _damping = Json.Required(args, "dampingConstant").GetDouble();
        double rest = Number(spring, _turns ? "targetAngle" : "restLength", _turns ? Turn() : Line().Length);

        // The original's bar between two bodies takes no target beyond that.
        const double LargestTarget = 5.5;
        bool isSet = spring.Properties.Any(p => p.Key == "targetAngle");
        _rest = hasTwo && isSet ? Math.Clamp(rest, -LargestTarget, LargestTarget) : rest;
        _most = Number(spring, "breakpoint", double.PositiveInfinity);
    }

    /// <exception cref="NotExpressedException">It has a property that is not known here.</exception>
    public static FineSpring Read(MadeObject spring, Func<string, FineBody> find)
        => spring.Properties.All(p => p.Key is "breakpoint" or "restLength" or "targetAngle")
            ? new FineSpring(spring, find)
            : throw new NotExpressedException("a property of a spring");

    public void BeginStep()
    {
        _broken |= _breaks;
        _breaks = Math.Abs(_error) > _most;
        _error = (_turns ? Turn() : Line().Length) - _rest;
    }

    public void Pull(double step)
    {
        if (_broken)
        {
            return;
        }

        if (_turns)
        {
            double torque = _stiffness * (Turn() - _rest);
            if (_first is { } first)
            {
                first.Spin += step * first.InverseInertia * (torque - (_damping * first.Spin));
            }

            _second.Spin += step * _second.InverseInertia * (-torque - (_damping * _second.Spin));
            return;
        }

        ((double px, double py), (double qx, double qy), double length) = Line();
        if (length < 1e-5)
        {
            return;
        }

        (double nx, double ny) = ((qx - px) / length, (qy - py) / length);
        (double ux, double uy) = _first?.VelocityAt(px, py) ?? (0, 0);
        (double vx, double vy) = _second.VelocityAt(qx, qy);
        double force = (_stiffness * (length - _rest)) + (_damping * (((vx - ux) * nx) + ((vy - uy) * ny)));
        _second.Push(qx, qy, -step * force * nx, -step * force * ny);
        _first?.Push(px, py, step * force * nx, step * force * ny);
    }

    private static (double X, double Y) Point(JsonElement args, string name)
        => Json.Optional(args, name) is { ValueKind: JsonValueKind.Array } at ? (at[0].GetDouble(), at[1].GetDouble()) : (0, 0);

    private static double Number(MadeObject spring, string name, double other)
        => spring.Properties.FirstOrDefault(p => p.Key == name).Value is { ValueKind: JsonValueKind.Number } e ? e.GetDouble() : other;

    private double Turn() => _second.Angle - (_first?.Angle ?? 0);

    private ((double X, double Y) From, (double X, double Y) To, double Length) Line()
    {
        (double X, double Y) from = _first?.ToWorld(_at1) ?? _at1;
        (double X, double Y) to = _second.ToWorld(_at2);
        return (from, to, Math.Sqrt(((to.X - from.X) * (to.X - from.X)) + ((to.Y - from.Y) * (to.Y - from.Y))));
    }
}
