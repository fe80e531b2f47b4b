using System;
using Farseer.Engine.Bodies;
using Farseer.Engine.Contacts;
using Farseer.Engine.Graph;
using Farseer.Engine.Stepping;

namespace Farseer.Engine.Solver;

/// <summary>
/// The passes over the contact rows, colour by colour: the rows of one colour share no body that moves, so they are cut into ranges for
/// the workers. Rows of the overflow may share bodies and are done by one.
/// </summary>
internal sealed unsafe class ContactPasses : IStageWork
{
    /// <summary>Bundles that are worth another worker's while, some 0.5 µs of a pass: a phase of two blocks takes 0.3 µs to share.</summary>
    private const int LeastBundles = 16;

    /// <summary>Bundles of a colour of a world whose rows are no longer near, some 8 MB in all colours.</summary>
    private const int MostNear = 384;

    private StageRunner _runner = null!;
    private BodyState* _states;
    private ContactCoefficients _coefficients;
    private Pass _pass;
    private bool _flag;
    private bool _first;
    private float _rate;
    private GraphColor _color = null!;

    private enum Pass
    {
        WarmStart,
        Biased,
        PushOut,
        Relax,
    }

    public void Begin(StageRunner runner, BodyStore bodies, in ContactCoefficients coefficients)
    {
        _runner = runner;
        _states = bodies.State.Pointer;
        _coefficients = coefficients;
    }

    public void WarmStart(ReadOnlySpan<GraphColor> colors) => Run(colors, Pass.WarmStart, false);

    public void SolveBiased(ReadOnlySpan<GraphColor> colors, bool anyDeep) => Run(colors, Pass.Biased, anyDeep);

    /// <param name="colors">The rows.</param>
    /// <param name="rub">With friction.</param>
    /// <param name="first">The only sweep, or the first, of the substep.</param>
    public void Relax(ReadOnlySpan<GraphColor> colors, bool rub, bool first)
    {
        _first = first;
        Run(colors, Pass.Relax, rub);
    }

    public void PushOut(ReadOnlySpan<GraphColor> colors, float rate)
    {
        _rate = rate;
        Run(colors, Pass.PushOut, false);
    }

    void IStageWork.Run(int worker, int from, int to)
    {
        BundleRuns runs = _color.Part(from, to);
        bool far = _color.BundleCount > MostNear;
        while (runs.Next())
        {
            var rows = new BundleRun(runs.Bundles, runs.Count, runs.Following, far, _color.IsSequential);
            if (_color.IsGrounded)
            {
                Run<ScatterMoving>(rows);
            }
            else
            {
                Run<ScatterAll>(rows);
            }
        }
    }

    private void Run<TScatter>(in BundleRun rows)
        where TScatter : struct, IVelocityScatter
    {
        if (OnePoint.Are(rows.Bundles, rows.Count))
        {
            Run<TScatter, OnePoint>(rows);
        }
        else
        {
            Run<TScatter, TwoPoints>(rows);
        }
    }

    private void Run<TScatter, TPoints>(in BundleRun rows)
        where TScatter : struct, IVelocityScatter
        where TPoints : struct, IContactPoints
    {
        switch (_pass)
        {
            case Pass.WarmStart:
                ContactKernel.WarmStart<TScatter, TPoints>(rows, _states, _coefficients);
                break;
            case Pass.Biased:
                ContactKernel.SolveBiased<TScatter, TPoints>(rows, _states, _coefficients, _flag);
                break;
            case Pass.PushOut:
                ContactKernel.PushOut<TScatter, TPoints>(rows, _states, _coefficients, _rate);
                break;
            case Pass.Relax:
                ContactKernel.Relax<TScatter, TPoints>(rows, _states, _coefficients, _flag, _first);
                break;
        }
    }

    private void Run(ReadOnlySpan<GraphColor> colors, Pass pass, bool flag)
    {
        _pass = pass;
        _flag = flag;
        for (int i = 0; i < colors.Length; i++)
        {
            _color = colors[i];
            _runner.Run(this, _color.BundleCount, _color.IsSequential ? int.MaxValue : LeastBundles);
        }
    }
}
