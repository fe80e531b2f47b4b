using Farseer.Engine.Numerics;

namespace Farseer.Engine.Bodies;

/// <summary>The exact solution of dv/dt = a - k·v over a time h: v·Keep + a·First, and x grows by v·First + a·Second.</summary>
internal readonly struct DragLaw
{
    private const double SeriesLimit = 0.05;

    /// <param name="k">Damping rate, 1/s, 0 or more.</param>
    /// <param name="h">Time, seconds.</param>
    public DragLaw(double k, double h)
    {
        double x = k * h;
        if (x == 0)
        {
            // What the series come to, to the bit: most bodies are not damped, and a small world has few others to share the divisions
            // with.
            Keep = 1;
            First = h;
            Second = h * h * 0.5;
        }
        else if (x < SeriesLimit)
        {
            // (1 - e^-x)/x and (x - 1 + e^-x)/x² as nested series: the closed forms lose their digits here. Error below 1e-13.
            double first = 1 - (x / 2 * (1 - (x / 3 * (1 - (x / 4 * (1 - (x / 5 * (1 - (x / 6 * (1 - (x / 7)))))))))));
            double second = 0.5 * (1 - (x / 3 * (1 - (x / 4 * (1 - (x / 5 * (1 - (x / 6 * (1 - (x / 7 * (1 - (x / 8))))))))))));
            Keep = 1 - (x * first);
            First = h * first;
            Second = h * h * second;
        }
        else
        {
            Keep = StableMath.Exp(-x);
            First = (1 - Keep) / k;
            Second = (h - First) / k;
        }
    }

    public double Keep { get; }

    public double First { get; }

    public double Second { get; }
}
