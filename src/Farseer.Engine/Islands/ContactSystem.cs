using System;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Islands;

/// <summary>One point of a contact in a <see cref="ContactSystem"/>: its surfaces part at n·(vB - vA) + wB·armB - wA·armA.</summary>
internal unsafe struct SystemPoint
{
    public ContactBundle* Bundle;
    public int Lane;

    /// <summary>It is the second point of its contact.</summary>
    public bool Second;

    /// <summary>It is one of those that push.</summary>
    public bool Pushes;
    public double ArmA;
    public double ArmB;

    /// <summary>How fast the surfaces are to part, less than they do without impulses: negative if they must be pushed.</summary>
    public double Excess;

    /// <summary>The impulse found.</summary>
    public double Impulse;

    public readonly ContactPointLanes* Lanes => Second ? &Bundle->Point1 : &Bundle->Point0;
}

/// <summary>
/// All points of a few contacts as one problem, solved directly: impulses x ≥ 0 and speeds w = A·x + b ≥ 0 with x·w = 0, A being what an
/// impulse at one point changes at another. Passes over the contacts take as many sweeps as one body is heavier than another; this takes
/// none. Points are moved between those that push (x = -b/A by a Cholesky factor) and those that part until none pulls and none approaches:
/// all wrong ones at once, which ends after a few turns, and one at a time when that does not get on.
/// </summary>
internal sealed unsafe class ContactSystem
{
    /// <summary>Points of the largest, for which a factor takes 0.1 ms.</summary>
    public const int MostPoints = 64;

    /// <summary>
    /// Softness that makes loads on more supports than needed definite. An error of this share times the ratio of the masses is what it
    /// costs, and rounding starts four digits below.
    /// </summary>
    private const double Softness = 1e-12;

    /// <summary>Shares of the largest impulse and speed below which they are rounding.</summary>
    private const double ImpulseRounding = 1e-12;
    private const double SpeedRounding = 1e-9;

    /// <summary>Turns in which the number of wrong points need not fall before they are moved one at a time.</summary>
    private const int Patience = 8;

    /// <summary>Turns for each point, after which the problem is left as it is.</summary>
    private const int TurnsAPoint = 4;

    private readonly Column<SystemPoint> _points = new Column<SystemPoint>();
    private readonly Column<int> _pushing = new Column<int>();

    // On the stack while it is solved: 64 KB for the largest.
    private double* _responses;
    private double* _factor;
    private double* _right;

    public int Count { get; private set; }

    public ref SystemPoint this[int index] => ref _points[index];

    public void Clear() => Count = 0;

    /// <summary>Makes room for so many points.</summary>
    public void Reserve(int points)
    {
        _points.EnsureCapacity(points);
        _pushing.EnsureCapacity(points);
    }

    public void Add(in SystemPoint point)
    {
        _points.EnsureCapacity(Count + 1);
        _points[Count++] = point;
    }

    /// <summary>Finds the impulses.</summary>
    /// <returns>False if none were found that hold everywhere.</returns>
    public bool Solve()
    {
        int n = Count;
        Reserve(n);
        System.Diagnostics.Debug.Assert(n <= MostPoints, "a system has so many points at most");
        double* memory = stackalloc double[((2 * n) + 1) * n];
        _responses = memory;
        _factor = memory + (n * n);
        _right = _factor + (n * n);
        double largest = 0;
        for (int i = 0; i < n; i++)
        {
            ref SystemPoint p = ref _points[i];
            p.Pushes = p.Excess < 0;
            largest = Math.Max(largest, Math.Abs(p.Excess));
            for (int j = 0; j <= i; j++)
            {
                double response = Response(p, _points[j]);
                _responses[(i * n) + j] = response;
                _responses[(j * n) + i] = response;
            }
        }

        int fewest = n + 1;
        int patience = Patience;
        for (int turn = 0; turn < TurnsAPoint * (n + 1); turn++)
        {
            if (!SolvePushing(n))
            {
                return false;
            }

            int wrong = FindWrong(n, SpeedRounding * largest, out int last);
            if (wrong == 0)
            {
                return true;
            }

            patience = wrong < fewest ? Patience : patience - 1;
            fewest = Math.Min(fewest, wrong);
            for (int i = 0; i < n; i++)
            {
                ref SystemPoint p = ref _points[i];
                if (_right[i] < 0 && (patience > 0 || i == last))
                {
                    p.Pushes = !p.Pushes;
                }
            }
        }

        return false;
    }

    /// <summary>How many points pull or approach, which <see cref="_right"/> tells by a negative number, and the last of them.</summary>
    private int FindWrong(int n, double leastSpeed, out int last)
    {
        double largest = 0;
        for (int i = 0; i < n; i++)
        {
            largest = Math.Max(largest, Math.Abs(_points[i].Impulse));
        }

        int wrong = 0;
        last = -1;
        for (int i = 0; i < n; i++)
        {
            bool isWrong;
            if (_points[i].Pushes)
            {
                isWrong = _points[i].Impulse < -ImpulseRounding * largest;
            }
            else
            {
                double speed = _points[i].Excess;
                for (int j = 0; j < n; j++)
                {
                    speed += _responses[(i * n) + j] * _points[j].Impulse;
                }

                isWrong = speed < -leastSpeed;
            }

            _right[i] = isWrong ? -1 : 1;
            wrong += isWrong ? 1 : 0;
            last = isWrong ? i : last;
        }

        return wrong;
    }

    /// <summary>The impulses of the points that push, by a Cholesky factor of their responses; the others have none.</summary>
    /// <returns>False if there is no factor.</returns>
    private bool SolvePushing(int n)
    {
        int count = 0;
        for (int i = 0; i < n; i++)
        {
            _points[i].Impulse = 0;
            if (_points[i].Pushes)
            {
                _pushing[count++] = i;
            }
        }

        for (int i = 0; i < count; i++)
        {
            double* row = _factor + (i * n);
            double* responses = _responses + (_pushing[i] * n);
            for (int j = 0; j <= i; j++)
            {
                double* other = _factor + (j * n);
                double sum = responses[_pushing[j]];
                sum = i == j ? sum * (1 + Softness) : sum;
                for (int k = 0; k < j; k++)
                {
                    sum -= row[k] * other[k];
                }

                if (i == j && !(sum > 0))
                {
                    return false;
                }

                row[j] = i == j ? Math.Sqrt(sum) : sum / other[j];
            }
        }

        for (int i = 0; i < count; i++)
        {
            double sum = -_points[_pushing[i]].Excess;
            for (int k = 0; k < i; k++)
            {
                sum -= _factor[(i * n) + k] * _right[k];
            }

            _right[i] = sum / _factor[(i * n) + i];
        }

        for (int i = count - 1; i >= 0; i--)
        {
            double sum = _right[i];
            for (int k = i + 1; k < count; k++)
            {
                sum -= _factor[(k * n) + i] * _right[k];
            }

            _right[i] = sum / _factor[(i * n) + i];
            _points[_pushing[i]].Impulse = _right[i];
        }

        return true;
    }

    /// <summary>What the impulse of the second point changes in the speed of the first.</summary>
    private static double Response(in SystemPoint p, in SystemPoint q)
    {
        double cosine = ((double)p.Bundle->NormalX[p.Lane] * q.Bundle->NormalX[q.Lane])
            + ((double)p.Bundle->NormalY[p.Lane] * q.Bundle->NormalY[q.Lane]);
        int a = p.Bundle->BodyA[p.Lane];
        int b = p.Bundle->BodyB[p.Lane];
        double sum = 0;
        if (q.Bundle->BodyA[q.Lane] == a)
        {
            sum += Share(p.Bundle->MassA[p.Lane], p.Bundle->InertiaA[p.Lane], cosine, p.ArmA, q.ArmA);
        }
        else if (q.Bundle->BodyB[q.Lane] == a)
        {
            sum -= Share(p.Bundle->MassA[p.Lane], p.Bundle->InertiaA[p.Lane], cosine, p.ArmA, q.ArmB);
        }

        if (q.Bundle->BodyB[q.Lane] == b)
        {
            sum += Share(p.Bundle->MassB[p.Lane], p.Bundle->InertiaB[p.Lane], cosine, p.ArmB, q.ArmB);
        }
        else if (q.Bundle->BodyA[q.Lane] == b)
        {
            sum -= Share(p.Bundle->MassB[p.Lane], p.Bundle->InertiaB[p.Lane], cosine, p.ArmB, q.ArmA);
        }

        return sum;
    }

    private static double Share(double mass, double inertia, double cosine, double arm, double other) =>
        (mass * cosine) + (inertia * arm * other);
}
